//! The simulated arm and its sand, one tick at a time.

use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, TryLockError};

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use soilctl_controller::Sensed as Readings;
use soilctl_kinematics::{JointAngles, MotorTorques};
use soilctl_plant::{Drive, Ground, Hardware, PlantError, PlantParams, SoilPreset, presets};

use crate::array::{Array, shaped, whole};
use crate::copies::maker;
use crate::earth_pressure::plane;
use crate::error::{Answer, Fail, file_at, input, kinds};

/// Torques beyond this are a mistake of the caller, in N m.
const MOST_TORQUE_NM: f64 = 1e4;
/// Ticks between two looks at Ctrl-C.
const LOOK: u64 = 64;

/// What the sensors report for one tick of 2 ms.
#[derive(Clone, Copy)]
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Sensed {
    readings: Readings,
}

#[pymethods]
impl Sensed {
    /// Number of the tick, from 1.
    #[getter]
    fn tick(&self) -> u64 {
        self.readings.tick
    }

    /// Counts of the motor encoders, shape (5,).
    #[getter]
    fn motor_counts<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        counts(py, &self.readings.motor_counts)
    }

    /// Counts of the external encoders, in the motors' coordinates, shape (5,).
    #[getter]
    fn external_counts<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        counts(py, &self.readings.external_counts)
    }

    /// Force (N) and moment (N m) of the soil on the plate in the sensor's frame, bias included, shape (6,).
    #[getter]
    fn wrench<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        shaped(py, self.readings.wrench.to_vec(), &[6])
    }

    /// Whether the force sensor reports an overload.
    #[getter]
    fn wrench_overload(&self) -> bool {
        self.readings.wrench_overload
    }

    /// Currents that the amplifiers report in A, shape (5,).
    #[getter]
    fn amplifier_current_a<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        shaped(py, self.readings.amplifier_current_a.to_vec(), &[5])
    }

    /// Supply voltages that the amplifiers report in V, shape (5,).
    #[getter]
    fn amplifier_voltage_v<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyAny>> {
        shaped(py, self.readings.amplifier_voltage_v.to_vec(), &[5])
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let (py, it) = (slf.py(), &slf.get().readings);
        let motors = (it.motor_counts, it.motor_sequence);
        let external = (it.external_counts, it.external_sequence);
        let wrench = (it.wrench, it.wrench_sequence, it.wrench_overload);
        let amplifiers = (it.amplifier_current_a, it.amplifier_voltage_v, it.amplifier_sequence);
        let args = (it.tick, motors, external, wrench, amplifiers).into_pyobject(py)?;
        Ok((maker(py, "_restore_sensed")?, args))
    }

    fn __repr__(&self) -> String {
        format!("Sensed(tick={}, wrench={:?})", self.readings.tick, self.readings.wrench)
    }
}

/// Readings as `__reduce__` has taken them apart.
#[pyfunction]
#[pyo3(name = "_restore_sensed")]
pub(crate) const fn restore_sensed(
    tick: u64,
    motors: ([i32; 5], u32),
    external: ([i32; 5], u32),
    wrench: ([f64; 6], u32, bool),
    amplifiers: ([f64; 5], [f64; 5], u32),
) -> Sensed {
    let (motor_counts, motor_sequence) = motors;
    let (external_counts, external_sequence) = external;
    let (wrench, wrench_sequence, wrench_overload) = wrench;
    let (amplifier_current_a, amplifier_voltage_v, amplifier_sequence) = amplifiers;
    Sensed {
        readings: Readings {
            tick,
            motor_counts,
            motor_sequence,
            external_counts,
            external_sequence,
            wrench,
            wrench_sequence,
            wrench_overload,
            amplifier_current_a,
            amplifier_voltage_v,
            amplifier_sequence,
        },
    }
}

/// Counts are whole numbers below 2^31, which floats hold.
fn counts<'py>(py: Python<'py>, counts: &[i32; 5]) -> Answer<Bound<'py, PyAny>> {
    let floats = shaped(py, counts.iter().copied().map(f64::from).collect(), &[5])?;
    Ok(floats.call_method1("astype", ("int64",))?)
}

/// The simulated digging arm with drives, sensors and, if a soil is named, a box of sand.
///
/// One step is a tick of 2 ms. The same arguments and torques give the same bits on every machine.
///
/// Args:
///     soil: One of ``soilctl.SOILS``; without one there is neither sand nor box.
///     joint_angles_deg: Where the arm starts, at rest, shape (5,).
///     model: Force model of the sand, one of ``soilctl.MODELS``.
///     surface_z_m: Height of the sand's surface in the base frame.
///     seed: Of the noise of sensors and soil.
///     file: Plant file; by default the arm of Hong (2001).
///
/// Raises:
///     InputError: If a name is unknown or a number out of its range.
///     FileError: If the file cannot be read.
///     NoAnswerError: If the joints cannot be there, or the model has no force for this soil.
#[pyclass(module = "soilctl", frozen)]
pub(crate) struct Plant {
    /// Never waited for, and never held while Python code may run: that might use the plant.
    inside: Mutex<Inside>,
}

struct Inside {
    plant: soilctl_plant::Plant,
    ticks: u64,
    /// Readings of the last tick; None before the first.
    last: Option<Readings>,
}

#[pymethods]
impl Plant {
    #[new]
    #[pyo3(signature = (
        soil = None, *, joint_angles_deg = None, model = "chen", surface_z_m = -0.3302, seed = 1, file = None
    ), text_signature = "(soil=None, *, joint_angles_deg=None, model='chen', surface_z_m=-0.3302, seed=1, file=None)")]
    fn new(
        soil: Option<&str>,
        joint_angles_deg: Option<&Bound<'_, PyAny>>,
        model: &str,
        surface_z_m: f64,
        #[pyo3(from_py_with = whole)] seed: u64,
        file: Option<PathBuf>,
    ) -> Answer<Self> {
        let params = match file {
            Some(file) => PlantParams::read(soilctl_kinematics::Arm::thesis(), &file)?,
            None => PlantParams::thesis(),
        };
        let start = match joint_angles_deg {
            Some(angles) => {
                Array::new("joint_angles_deg", angles)?.row::<5>("base, shoulder, elbow, twist, wrist")?
            }
            None => [0.0, 30.0, 100.0, 0.0, 30.0],
        };
        let ground = match soil {
            Some(name) => {
                let preset = SoilPreset::named(name)?;
                Some(Ground::new(&params, &preset, plane(model)?.as_ref(), surface_z_m, seed)?)
            }
            None => None,
        };
        let start = JointAngles::from_degrees(start);
        let plant = soilctl_plant::Plant::new(params, ground, &start, seed)?;
        Ok(Self { inside: Mutex::new(Inside { plant, ticks: 0, last: None }) })
    }

    /// Lets the motors act for one tick of 2 ms, then reads the sensors.
    ///
    /// Args:
    ///     motor_torques_nm: Torques of the motors, shape (5,).
    ///     amplifiers_enabled: If not, the torques count as zero.
    ///
    /// Raises:
    ///     InputError: If a torque is not finite or beyond 1e4 N m. The plant is as it was before.
    ///     SimulationError: If the arm left all bounds, or another thread is using the plant.
    #[pyo3(signature = (motor_torques_nm, *, amplifiers_enabled = true))]
    fn step(&self, motor_torques_nm: &Bound<'_, PyAny>, amplifiers_enabled: bool) -> Answer<Sensed> {
        let drive = drive(motor_torques_nm, amplifiers_enabled)?;
        self.exchange(&drive)
    }

    /// Runs a controller for some ticks: each tick its ``step(sensed)`` gives the motor torques, shape (5,), in N m.
    ///
    /// A callable does instead of an object with ``step``. It gets the readings of the tick before: a plant that has none yet
    /// runs its first tick with amplifiers off, so that the controller is called once less than there are ticks. Two runs of 500
    /// ticks are thus the same as one of 1000.
    ///
    /// Returns:
    ///     The last readings.
    ///
    /// Raises:
    ///     InputError: If a torque is not finite; the message names the tick whose readings the controller had, the plant is as
    ///         it was after that.
    ///     SimulationError: If the arm left all bounds, or another thread is using the plant.
    #[pyo3(signature = (controller, *, ticks))]
    fn run(
        &self,
        py: Python<'_>,
        controller: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole)] ticks: u64,
    ) -> Answer<Sensed> {
        if ticks == 0 {
            return Err(input("ticks is 0; it must be at least 1"));
        }
        let step = match controller.getattr("step") {
            Ok(step) => step,
            Err(_) if controller.is_callable() => controller.clone(),
            Err(_) => {
                let message = "the controller has no method step(sensed) and is not callable";
                return Err(Fail(kinds::InputTypeError::new_err(message)));
            }
        };
        let last = self.inside()?.last;
        let (mut sensed, done) = match last {
            Some(readings) => (Sensed { readings }, 0),
            None => (self.exchange(&Drive::default())?, 1),
        };
        for tick in done..ticks {
            let torques = step.call1((sensed,))?;
            let drive = drive(&torques, true).map_err(|fail| after(py, &sensed, fail))?;
            sensed = self.exchange(&drive)?;
            if tick % LOOK == 0 {
                py.check_signals()?;
            }
        }
        Ok(sensed)
    }

    /// Level sand again, with a density that scatters as the soil's does. To be called while the plate is out of it.
    ///
    /// Raises:
    ///     InputError: If there is no soil.
    ///     SimulationError: If another thread is using the plant.
    fn prepare_soil(&self) -> Answer<()> {
        match self.inside()?.plant.ground_mut() {
            Some(ground) => {
                ground.prepare();
                Ok(())
            }
            None => Err(input("there is no soil to prepare; name one when the plant is made")),
        }
    }

    /// The sand: a dict of ``friction_angle_deg``, ``interface_friction_deg``, ``cohesion_pa``, ``density_kg_m3`` (of the
    /// present preparation) and ``gravity_m_s2``; None without sand.
    #[getter]
    fn soil<'py>(&self, py: Python<'py>) -> Answer<Option<Bound<'py, PyDict>>> {
        let values = self.inside()?.plant.ground().map(|ground| {
            let (soil, interface) = (ground.soil(), ground.interface());
            [
                ("friction_angle_deg", soil.friction().degrees()),
                ("interface_friction_deg", interface.friction().degrees()),
                ("cohesion_pa", soil.cohesion_pa()),
                ("density_kg_m3", ground.density_kg_m3()),
                ("gravity_m_s2", soil.gravity_m_s2()),
            ]
        });
        let Some(values) = values else { return Ok(None) };
        let dict = PyDict::new(py);
        for (key, value) in values {
            dict.set_item(key, value)?;
        }
        Ok(Some(dict))
    }

    /// Ticks run since the plant was made.
    #[getter]
    fn ticks(&self) -> Answer<u64> {
        Ok(self.inside()?.ticks)
    }

    /// What no sensor tells, as of the last tick: a dict of true joint angles, tip, wrench and soil.
    #[getter]
    fn truth<'py>(&self, py: Python<'py>) -> Answer<Bound<'py, PyDict>> {
        let truth = *self.inside()?.plant.truth();
        let soil = &truth.soil;
        let dict = PyDict::new(py);
        dict.set_item("joint_angles_rad", shaped(py, truth.joints.0.to_vec(), &[5])?)?;
        dict.set_item("tip_m", shaped(py, truth.tip_m.to_vec(), &[3])?)?;
        dict.set_item("wrench", shaped(py, truth.wrench.to_vec(), &[6])?)?;
        for (key, value) in [
            ("depth_m", soil.depth_m),
            ("heap_m", soil.heap_m),
            ("tool_angle_rad", soil.tool_angle_rad),
            ("limit_force_n", soil.limit_force_n),
            ("limit_force_now_n", soil.limit_force_now_n),
            ("normal_n", soil.normal_n),
            ("tangent_n", soil.tangent_n),
            ("lateral_n", soil.lateral_n),
            ("mobilisation", soil.mobilisation),
            ("slip_m", soil.slip_m),
        ] {
            dict.set_item(key, value)?;
        }
        dict.set_item("failing", soil.failing)?;
        Ok(dict)
    }

    /// Energy of links, rotors and stretch in J.
    ///
    /// Raises:
    ///     SimulationError: If the arm is lost.
    #[getter]
    fn energy_j(&self) -> Answer<f64> {
        Ok(self.inside()?.plant.energy_j()?)
    }

    fn __reduce__(&self) -> Answer<()> {
        let message = "a plant is a simulation that goes on, and cannot be copied or pickled; make another one with the same \
                       arguments and give it the same torques";
        Err(Fail(PyTypeError::new_err(message)))
    }

    fn __repr__(&self) -> Answer<String> {
        Ok(format!("Plant(ticks={})", self.ticks()?))
    }
}

impl Plant {
    fn inside(&self) -> Answer<MutexGuard<'_, Inside>> {
        match self.inside.try_lock() {
            Ok(inside) => Ok(inside),
            Err(TryLockError::Poisoned(inside)) => Ok(inside.into_inner()),
            Err(TryLockError::WouldBlock) => {
                Err(Fail(kinds::SimulationError::new_err("the plant is in use by another thread")))
            }
        }
    }

    fn exchange(&self, drive: &Drive) -> Answer<Sensed> {
        let mut inside = self.inside()?;
        let readings = inside.plant.exchange(drive)?;
        inside.ticks += 1;
        inside.last = Some(readings);
        Ok(Sensed { readings })
    }
}

/// What a controller gave for readings, refused: with their tick in front. Exceptions of other kinds stay what they are.
fn after(py: Python<'_>, sensed: &Sensed, fail: Fail) -> Fail {
    let Fail(refused) = fail;
    if !refused.is_instance_of::<kinds::InputError>(py) {
        return Fail(refused);
    }
    let message = format!("after tick {}: {}", sensed.readings.tick, refused.value(py));
    let named = PyErr::from_type(refused.get_type(py), message);
    named.set_cause(py, refused.cause(py));
    Fail(named)
}

/// Checked before the plant sees it.
fn drive(torques: &Bound<'_, PyAny>, amplifiers_enabled: bool) -> Answer<Drive> {
    let torques = Array::new("motor_torques_nm", torques)?.row::<5>("one a motor")?;
    if let Some(motor) = torques.iter().position(|torque| torque.abs() > MOST_TORQUE_NM) {
        let torque = torques[motor];
        return Err(input(format!(
            "motor_torques_nm[{motor}] is {torque} N m; it must be between -{MOST_TORQUE_NM} and {MOST_TORQUE_NM} N m"
        )));
    }
    Ok(Drive { motor_torques: MotorTorques(torques), amplifiers_enabled })
}

/// Names of the soils that a plant can have.
#[pyfunction]
pub(crate) fn soil_names() -> Vec<String> {
    presets().into_iter().map(|preset| preset.name).collect()
}

impl From<PlantError> for Fail {
    fn from(problem: PlantError) -> Self {
        match problem {
            PlantError::Diverged { .. } => Self(kinds::SimulationError::new_err(problem.to_string())),
            PlantError::Io { file: ref path, .. } => file_at(&problem, path),
            PlantError::Kinematics(problem) => problem.into(),
            PlantError::Force(problem) => problem.into(),
            _ => input(problem),
        }
    }
}
