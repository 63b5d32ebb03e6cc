//! Rows that say what soil, plate and far ground bear, in units of the depth.

use soilctl_conic::{Form, Program};

use super::complex::{Complex, up};
use super::sheets::Sheets;

/// Strengths of soil and plate.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strengths {
    /// `K = (1 + sin(phi))/(1 - sin(phi))`.
    pub(super) ratio: f64,
    /// `tan(delta)`.
    pub(super) slip: f64,
}

impl Strengths {
    pub(super) fn new(phi_deg: f64, delta_deg: f64) -> Self {
        let sin = phi_deg.to_radians().sin();
        Self { ratio: (1.0 + sin) / (1.0 - sin), slip: delta_deg.to_radians().tan() }
    }

    /// In space: `P - t` and `K t - P` have no negative eigenvalue. The upper triangle of `P` by columns.
    pub(super) fn soil(&self, stress: &[Form; 6], program: &mut Program) {
        let t = program.unknown();
        let with = |sign: f64, t_times: f64| {
            std::array::from_fn(|k| {
                let mut form = stress[k].clone();
                form.constant *= sign;
                form.terms.iter_mut().for_each(|(_, c)| *c *= sign);
                if [0, 2, 5].contains(&k) {
                    form.terms.push((t, t_times));
                }
                form
            })
        };
        program.semidefinite(with(1.0, -1.0));
        program.semidefinite(with(-1.0, self.ratio));
    }

    /// In the plane, with a pressure across: the same, where eigenvalues are those of the plane and that pressure.
    pub(super) fn plane(&self, [xx, xz, zz]: &[Form; 3], across: &Form, program: &mut Program) {
        let t = program.unknown();
        let half = xx.clone().plus(1.0, zz);
        let radius = [Form::default().plus(0.5, xx).plus(-0.5, zz), xz.clone()];
        for (sign, t_times) in [(0.5, -1.0), (-0.5, self.ratio)] {
            let t = Form::unknown(t, t_times);
            let [a, b] = radius.clone();
            program.second_order([Form::default().plus(sign, &half).plus(1.0, &t), a, b]);
            program.non_negative(t.plus(2.0 * sign, across));
        }
    }

    /// What presses on the plate's faces, and on planes of the box other than `given`.
    pub(super) fn faces<const N: usize, const M: usize>(
        &self,
        complex: &Complex<N, M>,
        sheets: &Sheets<N>,
        given: impl Fn(&[f64; N], usize) -> bool,
        program: &mut Program,
    ) {
        for (sheet, &number) in complex.sheets.iter().enumerate() {
            let face = &complex.faces[number];
            for (vertex, &corner) in face.corners.iter().enumerate() {
                let depth = complex.depth(corner);
                if depth == 0.0 {
                    continue;
                }
                let along = |axes| sheets.stress(complex, sheet, vertex, axes, 1.0 / depth);
                if face.plate.is_some() {
                    let most = Form::default().plus(self.slip, &along([0, 0]));
                    self.face(most, (1..N).map(|axis| along([axis, 0])).collect(), along([0, 0]), program);
                } else if let Some(axis) = face.rim.filter(|&axis| !given(&complex.places[corner], axis)) {
                    let pressure = along([axis, axis]);
                    program.non_negative(Form::constant(-1.0).plus(self.ratio, &pressure));
                    program.non_negative(Form::constant(self.ratio).plus(-1.0, &pressure));
                }
            }
        }
    }

    fn face(&self, most: Form, shears: Vec<Form>, pressure: Form, program: &mut Program) {
        match &shears[..] {
            _ if self.slip == 0.0 => program.non_negative(pressure),
            [first, second] => program.second_order([most, first.clone(), second.clone()]),
            _ => {
                for shear in shears {
                    program.non_negative(most.clone().plus(1.0, &shear));
                    program.non_negative(most.clone().plus(-1.0, &shear));
                }
            }
        }
    }
}

/// The force of the plate on the soil along x, in the mesh.
pub(super) fn force<const N: usize, const M: usize>(complex: &Complex<N, M>, sheets: &Sheets<N>) -> Form {
    let mut force = Form::default();
    // The integral over a face of what is linear on it, with a normal as long as that of `Face`.
    let share = if up::<N>() == 1 { 0.5 } else { 1.0 / 6.0 };
    for [ahead, behind] in complex.plates() {
        let sign = share * complex.faces[ahead].normal[0].signum();
        for vertex in 0..N {
            for (sheet, sign) in [(ahead, sign), (behind, -sign)] {
                force.add(1.0, &sheets.0[sheet][vertex][0].form(sign));
            }
        }
    }
    force
}
