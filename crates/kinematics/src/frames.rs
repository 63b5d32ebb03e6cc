use crate::{Arm, JointAngles, KinematicsError};

/// Place and attitude of a frame in the base frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Rotation matrix; its columns are the frame's axes in base coordinates.
    pub rotation: [[f64; 3]; 3],
    /// Origin in m.
    pub origin_m: [f64; 3],
}

/// The frames of all links, under the names they have in the URDF.
///
/// Each link's z axis runs outwards along the link, its y axis is that of the joint that bends it. With all joints at
/// zero every frame but the sensor's is parallel to the base frame: x forwards, z up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinkFrames {
    /// Turns with theta_0; origin at the base frame's origin.
    pub column: Frame,
    /// Origin at the shoulder.
    pub upper_arm: Frame,
    /// Origin at the elbow.
    pub forearm: Frame,
    /// Origin at the twist joint.
    pub twist: Frame,
    /// Origin at the wrist; z along the hand, y along the plate's lower edge, x normal to the plate.
    pub hand: Frame,
    /// The force sensor: x along the hand to the tip, y as the hand's, z against the hand's x, which is away from the
    /// base when the plate hangs down.
    pub ft_sensor: Frame,
    /// Origin in the middle of the plate's lower edge, axes as the hand's.
    pub plate_tip: Frame,
}

impl LinkFrames {
    /// Names and frames from the base outwards.
    #[must_use]
    pub const fn named(&self) -> [(&'static str, Frame); 7] {
        [
            ("column_link", self.column),
            ("upper_arm_link", self.upper_arm),
            ("forearm_link", self.forearm),
            ("twist_link", self.twist),
            ("hand_link", self.hand),
            ("ft_sensor", self.ft_sensor),
            ("plate_tip", self.plate_tip),
        ]
    }
}

impl Frame {
    const BASE: Self =
        Self { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin_m: [0.0; 3] };

    /// A point of this frame (m) in base coordinates.
    #[must_use]
    pub fn point_m(&self, point: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| self.origin_m[i] + dot(self.rotation[i], point))
    }

    /// A direction of this frame in base coordinates.
    #[must_use]
    pub fn direction(&self, vector: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| dot(row, vector))
    }

    /// The attitude as a unit quaternion (x, y, z, w), the order of ROS messages; w or else the largest part is
    /// positive.
    #[must_use]
    pub fn quaternion_xyzw(&self) -> [f64; 4] {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.rotation;
        // Four times the squares of x, y, z, w: start from the largest, so that nothing small is divided by.
        let squares = [1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz, 1.0 + xx + yy + zz];
        let candidates = [
            [squares[0], xy + yx, zx + xz, zy - yz],
            [xy + yx, squares[1], yz + zy, xz - zx],
            [zx + xz, yz + zy, squares[2], yx - xy],
            [zy - yz, xz - zx, yx - xy, squares[3]],
        ];
        let mut largest = 3;
        for i in 0..3 {
            if squares[i] > squares[largest] {
                largest = i;
            }
        }
        let four = candidates[largest];
        let length = four.iter().map(|part| part * part).sum::<f64>().sqrt();
        let sign = if four[3] < 0.0 { -1.0 } else { 1.0 };
        four.map(|part| sign * part / length)
    }

    fn along_z(self, distance_m: f64) -> Self {
        Self { origin_m: self.point_m([0.0, 0.0, distance_m]), ..self }
    }

    fn about_z(self, angle: f64) -> Self {
        let (s, c) = libm::sincos(angle);
        Self { rotation: self.rotation.map(|[x, y, z]| [x * c + y * s, y * c - x * s, z]), ..self }
    }

    fn about_y(self, angle: f64) -> Self {
        let (s, c) = libm::sincos(angle);
        Self { rotation: self.rotation.map(|[x, y, z]| [x * c - z * s, y, x * s + z * c]), ..self }
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl Arm {
    /// The frames of all links when the joints are at `joints`, one joint after the other from the base outwards.
    ///
    /// # Errors
    /// [`KinematicsError::NonFinite`] or [`KinematicsError::OutOfRange`] if an angle is not a finite number of at
    /// most 1000 rad.
    pub fn frames(&self, joints: &JointAngles) -> Result<LinkFrames, KinematicsError> {
        let [theta_0, theta_1, theta_2, theta_3, theta_4] = joints.checked()?;
        let links = &self.config().links;
        let column = Frame::BASE.about_z(theta_0);
        let upper_arm = column.along_z(links.base_height_m).about_y(theta_1);
        let forearm = upper_arm.along_z(links.upper_arm_m).about_y(theta_2);
        let twist = forearm.along_z(links.forearm_m).about_z(theta_3);
        let hand = twist.along_z(links.twist_m).about_y(theta_4);
        let plate_tip = hand.along_z(links.hand_m);
        let mut ft_sensor = hand.along_z(links.hand_m - self.config().sensor.before_tip_m);
        ft_sensor.rotation = ft_sensor.rotation.map(|[x, y, z]| [z, y, -x]);
        Ok(LinkFrames { column, upper_arm, forearm, twist, hand, ft_sensor, plate_tip })
    }
}
