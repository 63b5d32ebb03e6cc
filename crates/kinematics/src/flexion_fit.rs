use crate::error::check_size;
use crate::{Arm, Compliance, JointAngles, KinematicsError};

/// One push of the held plate against a rigid stop (appendix A.2): the arm's end stays, the encoders move.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Push {
    /// Joint angles at first contact, before any force.
    pub contact: JointAngles,
    /// Joint angles that the encoders show under the force.
    pub pressed: JointAngles,
    /// Force in N (x, y, z) with which the plate presses on the stop.
    pub plate_on_stop_n: [f64; 3],
}

/// A compliance found by least squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ComplianceFit {
    /// The compliance.
    pub compliance: Compliance,
    /// Root mean square of what the fit leaves of the deflections at shoulder and elbow, in rad.
    pub rms_rad: [f64; 2],
    /// Pushes used.
    pub pushes: usize,
}

/// Sum of squared torques, in (N m)^2, below which a joint counts as not loaded.
const LEAST_LOAD: f64 = 1e-12;

/// A push in the terms of the fit: torques (N m) and deflections (rad) of shoulder and elbow.
struct Load {
    torque: [f64; 2],
    deflection: [f64; 2],
}

impl Compliance {
    /// The full matrix from pushes in at least two places or directions (eqs A.1, A.2).
    ///
    /// The deflections are regressed on the torques, not the reverse as A.2 is written: a coarse encoder makes the
    /// deflections the noisy side, and noise in a regressor would make every stiffness too small.
    ///
    /// # Errors
    /// [`KinematicsError::Pushes`] unless the torques of two pushes differ clearly in their ratio; otherwise as
    /// [`Arm::shoulder_elbow_torques`].
    pub fn fit(arm: &Arm, pushes: &[Push]) -> Result<ComplianceFit, KinematicsError> {
        let loads = loads(arm, pushes)?;
        let sum = |f: &dyn Fn(&Load) -> f64| loads.iter().map(f).sum::<f64>();
        let (t11, t12, t22) = (
            sum(&|l| l.torque[0] * l.torque[0]),
            sum(&|l| l.torque[0] * l.torque[1]),
            sum(&|l| l.torque[1] * l.torque[1]),
        );
        let determinant = t11 * t22 - t12 * t12;
        // The sine of the angle between the torques, squared; 1e-4 is about half a degree.
        let varied = t11.min(t22) > LEAST_LOAD && determinant > 1e-4 * t11 * t22;
        if !varied {
            return Err(KinematicsError::Pushes {
                problem: "torques at shoulder and elbow in at least two different ratios are needed",
                used: loads.iter().filter(|l| l.torque != [0.0; 2]).count(),
                given: pushes.len(),
                advice: "push in other directions or postures, or fit the elbow alone",
            });
        }
        let rad_per_nm = [0, 1].map(|joint| {
            let d1 = sum(&|l| l.deflection[joint] * l.torque[0]);
            let d2 = sum(&|l| l.deflection[joint] * l.torque[1]);
            [(d1 * t22 - d2 * t12) / determinant, (d2 * t11 - d1 * t12) / determinant]
        });
        Ok(judged(Self { rad_per_nm }, &loads))
    }

    /// The elbow's compliance alone, as the thesis ends up using it; one push is enough.
    ///
    /// # Errors
    /// [`KinematicsError::Pushes`] if no push loads the elbow; otherwise as [`Arm::shoulder_elbow_torques`].
    pub fn fit_elbow(arm: &Arm, pushes: &[Push]) -> Result<ComplianceFit, KinematicsError> {
        let loads = loads(arm, pushes)?;
        let squares: f64 = loads.iter().map(|l| l.torque[1] * l.torque[1]).sum();
        if squares < LEAST_LOAD {
            return Err(KinematicsError::Pushes {
                problem: "at least one push that loads the elbow is needed",
                used: 0,
                given: pushes.len(),
                advice: "push across the line from the elbow to the tip",
            });
        }
        let product: f64 = loads.iter().map(|l| l.torque[1] * l.deflection[1]).sum();
        Ok(judged(Self { rad_per_nm: [[0.0, 0.0], [0.0, product / squares]] }, &loads))
    }
}

fn loads(arm: &Arm, pushes: &[Push]) -> Result<Vec<Load>, KinematicsError> {
    pushes
        .iter()
        .map(|push| {
            // The true posture is that of the contact: the end is held.
            let torque = arm.shoulder_elbow_torques(&push.contact, push.plate_on_stop_n)?;
            let deflection = [1, 2].map(|i| push.pressed.0[i] - push.contact.0[i]);
            check_size(
                "deflection",
                &deflection,
                1.0,
                "rad",
                "between -1 and 1 rad; give each push its own contact",
            )?;
            Ok(Load { torque, deflection })
        })
        .collect()
}

fn judged(compliance: Compliance, loads: &[Load]) -> ComplianceFit {
    let rms_rad = [0, 1].map(|joint| {
        let row = compliance.rad_per_nm[joint];
        let left = |l: &Load| l.deflection[joint] - row[0] * l.torque[0] - row[1] * l.torque[1];
        (loads.iter().map(|l| left(l) * left(l)).sum::<f64>() / loads.len().max(1) as f64).sqrt()
    });
    ComplianceFit { compliance, rms_rad, pushes: loads.len() }
}
