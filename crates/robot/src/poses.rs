use nalgebra::Isometry3;

use crate::Urdf;
use crate::chain::{Motion, finite};
use crate::mimic::Drive;
use crate::model::{Joint, JointKind};

impl Urdf {
    /// From the frame of each link to that of the root, in the order of [`Urdf::links`], to draw all of them.
    ///
    /// `position` gives the position (rad, or m of a joint that slides) of a joint by its name; one that it does not know is
    /// at 0. It is asked for joints that move by themselves only. A link is `None` where this does not say where it is: behind
    /// a floating or planar joint, a mimic that cannot be followed, or a position that is no finite number.
    #[must_use]
    pub fn link_poses(&self, position: &dyn Fn(&str) -> Option<f64>) -> Vec<Option<Isometry3<f64>>> {
        let mut poses: Vec<Option<Isometry3<f64>>> = vec![None; self.links().len()];
        for &link in self.outwards() {
            let pose = match self.joint_above(link) {
                None => Some(Isometry3::identity()),
                Some(number) => self.joints().get(number).and_then(|joint| {
                    let parent = poses.get(joint.parent).copied().flatten()?;
                    finite(parent * joint.origin * self.motion(number, joint, position)?)
                }),
            };
            if let Some(place) = poses.get_mut(link) {
                *place = pose;
            }
        }
        poses
    }

    /// What a joint does; `None` if it cannot be said.
    fn motion(
        &self,
        number: usize,
        joint: &Joint,
        position: &dyn Fn(&str) -> Option<f64>,
    ) -> Option<Isometry3<f64>> {
        match (self.drive(number), Motion::of(joint)) {
            (Drive::By { source, multiplier, offset }, Some(motion)) => {
                let leader = position(&self.joints().get(source)?.name).unwrap_or(0.0);
                Some(motion.at(multiplier * leader + offset))
            }
            _ => (joint.kind == JointKind::Fixed).then(Isometry3::identity),
        }
    }
}
