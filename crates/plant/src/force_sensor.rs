use soilctl_kinematics::Frame;

use crate::bodies::PointForce;
use crate::config::ForceSensorConfig;
use crate::noise::Noise;

impl ForceSensorConfig {
    /// Ranges of the six channels in N and N m.
    pub(crate) fn ranges(&self) -> [f64; 6] {
        let (shear, moment) = (self.shear_range_n, self.moment_range_nm);
        [shear, shear, self.normal_range_n, moment, moment, moment]
    }

    fn overloads(&self) -> [f64; 6] {
        let (shear, moment) = (self.overload_shear_n, self.overload_moment_nm);
        [shear, shear, self.overload_normal_n, moment, moment, moment]
    }
}

/// One reading.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reading {
    pub(crate) wrench: [f64; 6],
    pub(crate) overload: bool,
}

/// The sensor behind the plate: loads are summed over the substeps of a tick, as the real one filters at 4 kHz.
#[derive(Debug, Clone)]
pub(crate) struct ForceSensor {
    config: ForceSensorConfig,
    /// In the middle of the plate, from the sensor's origin along its x axis, in m.
    carried_at_m: f64,
    sum: [f64; 6],
    count: f64,
    /// The mean load of the last tick in N and N m.
    pub(crate) load: [f64; 6],
    /// Noise of the last reading, in its standard deviation.
    noise: [f64; 6],
    damaged: bool,
}

impl ForceSensor {
    pub(crate) fn new(config: &ForceSensorConfig, before_tip_m: f64, plate_height_m: f64) -> Self {
        Self {
            config: *config,
            carried_at_m: before_tip_m - 0.5 * plate_height_m,
            sum: [0.0; 6],
            count: 0.0,
            load: [0.0; 6],
            noise: [0.0; 6],
            damaged: false,
        }
    }

    /// Adds the loads of a substep; `frame` is that of the sensor, gravity points along -z.
    pub(crate) fn add(&mut self, frame: &Frame, gravity_m_s2: f64, loads: &[PointForce]) {
        let weight = PointForce {
            force_n: [0.0, 0.0, -self.config.mass_behind_kg * gravity_m_s2],
            point_m: frame.point_m([self.carried_at_m, 0.0, 0.0]),
        };
        for load in loads.iter().chain([&weight]) {
            let arm: [f64; 3] = std::array::from_fn(|i| load.point_m[i] - frame.origin_m[i]);
            let moment = cross(arm, load.force_n);
            for axis in 0..3 {
                for ((row, force), moment) in frame.rotation.iter().zip(load.force_n).zip(moment) {
                    self.sum[axis] += row[axis] * force;
                    self.sum[axis + 3] += row[axis] * moment;
                }
            }
        }
        self.count += 1.0;
    }

    /// The reading of the tick that ends.
    pub(crate) fn read(&mut self, noise: &mut Noise) -> Reading {
        let (ranges, overloads) = (self.config.ranges(), self.config.overloads());
        let mut saturated = false;
        if self.count > 0.0 {
            self.load = self.sum.map(|sum| sum / self.count);
        }
        (self.sum, self.count) = ([0.0; 6], 0.0);
        let correlation = self.config.noise_correlation;
        let fresh = (1.0 - correlation * correlation).sqrt();
        let wrench = std::array::from_fn(|i| {
            self.damaged |= self.load[i].abs() > overloads[i];
            let sd = if i < 3 { self.config.noise_n } else { self.config.noise_nm };
            self.noise[i] = correlation * self.noise[i] + fresh * noise.normal();
            let value = self.config.scale[i] * self.load[i] + self.config.bias[i] + sd * self.noise[i];
            // The last step below the end of the range is where the converter stops.
            let step = 2.0 * ranges[i] / libm::exp2(f64::from(self.config.bits));
            let end = ranges[i] - step;
            saturated |= value.abs() > end;
            ((value / step).round() * step).max(-end).min(end)
        });
        Reading { wrench, overload: saturated || self.damaged }
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SENSOR: ForceSensorConfig = ForceSensorConfig {
        shear_range_n: 100.0,
        normal_range_n: 300.0,
        moment_range_nm: 5.0,
        bits: 16,
        noise_n: 0.0,
        noise_nm: 0.0,
        noise_correlation: 0.0,
        bias: [0.0; 6],
        scale: [1.0; 6],
        overload_shear_n: 1300.0,
        overload_normal_n: 2900.0,
        overload_moment_nm: 25.0,
        mass_behind_kg: 0.0,
    };
    const UPRIGHT: Frame =
        Frame { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin_m: [0.1, 0.0, 0.0] };

    fn read(config: ForceSensorConfig, force_n: [f64; 3], point_m: [f64; 3]) -> Reading {
        let mut sensor = ForceSensor::new(&config, 0.0889, 0.0635);
        sensor.add(&UPRIGHT, 9.81, &[PointForce { force_n, point_m }]);
        sensor.read(&mut Noise::new(0))
    }

    #[test]
    fn forces_have_moments_and_whole_steps() {
        let reading = read(SENSOR, [0.0, 0.0, 10.0], [0.2, 0.05, 0.0]);
        // (0.1, 0.05, 0) x (0, 0, 10) = (0.5, -1, 0).
        let expected = [0.0, 0.0, 10.0, 0.5, -1.0, 0.0];
        for (i, range) in SENSOR.ranges().into_iter().enumerate() {
            let step = 2.0 * range / 65_536.0;
            assert!((reading.wrench[i] - expected[i]).abs() <= 0.5 * step);
            assert!((reading.wrench[i] / step).fract().abs() < 1e-9);
        }
        assert!(!reading.overload);
    }

    #[test]
    fn the_ends_of_the_range_and_damage() {
        let reading = read(SENSOR, [150.0, 0.0, 0.0], [0.1, 0.0, 0.0]);
        assert!(reading.overload && reading.wrench[0] < 100.0 && reading.wrench[0] > 99.9);
        let mut sensor = ForceSensor::new(&SENSOR, 0.0889, 0.0635);
        let hit = PointForce { force_n: [0.0, 0.0, 3000.0], point_m: UPRIGHT.origin_m };
        sensor.add(&UPRIGHT, 9.81, &[hit]);
        assert!(sensor.read(&mut Noise::new(0)).overload);
        sensor.add(&UPRIGHT, 9.81, &[]);
        assert!(sensor.read(&mut Noise::new(0)).overload, "it stays damaged");
    }

    /// Neighbours are correlated as stated, the standard deviation does not depend on it.
    #[test]
    fn noise_remembers() {
        for expected in [0.0, 0.6] {
            let config = ForceSensorConfig { noise_n: 1.0, noise_correlation: expected, ..SENSOR };
            let (mut sensor, mut noise) = (ForceSensor::new(&config, 0.0889, 0.0635), Noise::new(3));
            let read: Vec<f64> = (0..100_000).map(|_| sensor.read(&mut noise).wrench[2]).collect();
            let of = |lag: usize| {
                let pairs = read.iter().zip(&read[lag..]);
                pairs.map(|(a, b)| a * b).sum::<f64>() / read.len() as f64
            };
            assert!((of(0) - 1.0).abs() < 0.03, "{}", of(0));
            assert!(
                (of(1) - expected).abs() < 0.02 && (of(2) - expected * expected).abs() < 0.02,
                "{expected}: {}",
                of(1)
            );
        }
    }

    #[test]
    fn it_feels_what_it_carries() {
        let config = ForceSensorConfig { mass_behind_kg: 0.1, ..SENSOR };
        let reading = read(config, [0.0; 3], [0.0; 3]);
        assert!((reading.wrench[2] + 0.981).abs() < 0.01, "{reading:?}");
        assert!((reading.wrench[4] - 0.981 * (0.0889 - 0.031_75)).abs() < 0.001, "{reading:?}");
    }
}
