//! The meshes of a run.

use super::run::{FIRST, Run};
use crate::adapt::wanted_sizes;
use crate::error::LimitError;
use crate::lower::apart;
use crate::mesh::{Fan, Guide, Mesh, Request, SizeField, generate};
use crate::topology::Topology;

impl Run<'_> {
    /// A mesh of about `target` triangles.
    pub(super) fn mesh(
        &self,
        target: f64,
        fans: &[Fan],
        guides: &[Guide],
    ) -> Result<(Mesh, Topology), LimitError> {
        // Until shares are known, all of it gets finer.
        let finer = (FIRST / target).sqrt();
        let first = |p: [f64; 2]| finer * self.begin.size(p);
        let of = |(mesh, shares): &(Mesh, Vec<f64>)| {
            wanted_sizes(mesh, shares, target as usize, self.begin.largest)
        };
        let later = self.shares.as_ref().map(of).transpose()?;
        let later = later.as_ref().map(|field: &SizeField| |p: [f64; 2]| field.size(p));
        let slides = |p: [f64; 2]| self.begin.slides.iter().map(|s| s.size(p)).fold(f64::INFINITY, f64::min);
        let size: &dyn Fn([f64; 2]) -> f64 = match &later {
            Some(size) => size,
            None => &first,
        };
        let mesh = generate(&Request {
            statement: self.problem.statement(),
            guides,
            fans,
            size: &|p| size(p).min(slides(p)),
            // The size field asks for about the target; the fans come on top.
            max_triangles: 4 * self.options.max_elements + 10_000,
        })?;
        let mesh = apart(self.problem, mesh);
        let topology = Topology::new(&mesh);
        Ok((mesh, topology))
    }

    /// A mesh for the lower bound, as fine as that of a level, where it differs.
    pub(super) fn lower_mesh(&self, level: usize) -> Result<Option<(Mesh, Topology)>, LimitError> {
        let fans = match self.begin.lower_fans(self.spared + level) {
            Some(fans) => fans,
            // That of the upper bound is cut.
            None if !self.begin.slides.is_empty() => self.begin.fans(self.spared + level),
            None => return Ok(None),
        };
        let target = if level == 0 { self.target } else { self.meshes[level].0.triangles.len() as f64 };
        Ok(Some(self.mesh(target, &fans, &self.guides)?))
    }
}
