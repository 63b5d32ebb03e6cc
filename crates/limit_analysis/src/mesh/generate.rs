use super::MeshError;
use super::cut::line_profiles;
use super::domain::Domain;
use super::extract::Mesh;
use super::fan::{Fan, discs};
use super::guide::{Guide, Trail, forced};
use super::trim::trim;
use super::wanted::Wanted;
use super::work::Work;
use soilctl_certificate::Statement;

/// What to mesh, and how finely.
pub struct Request<'a> {
    /// The geometry.
    pub statement: &'a Statement,
    /// Lines that edges shall follow, in order of importance: the first ones give way last.
    pub guides: &'a [Guide],
    /// Corners with fans of triangles, at most 1000.
    pub fans: &'a [Fan],
    /// Wanted edge length (m) at a point; positive. It may be rough and have jumps: the edge length grows by at most
    /// some 30 % from element to element.
    pub size: &'a dyn Fn([f64; 2]) -> f64,
    /// Most triangles to make.
    pub max_triangles: usize,
}

/// Makes a mesh. The same request gives the same mesh, bit by bit.
///
/// Most edges are within 40 % of the wanted length, except in and near fans. Angles are above 20 degrees except in fans
/// and next to smaller angles between lines.
///
/// # Errors
///
/// [`MeshError`] for a statement that is too large or too fine to mesh, [`MeshError::BadSize`] for a wanted size that is not positive,
/// [`MeshError::BadGuide`] for coordinates that are not finite, [`MeshError::BadFan`] for a fan that is not at a corner or
/// of no possible shape, and [`MeshError::TooManyTriangles`] if more than `max_triangles` are needed.
pub fn generate(request: &Request) -> Result<Mesh, MeshError> {
    let domain = Domain::new(request.statement)?;
    let mut discs = discs(&domain, request.fans)?;
    let mut trails = Vec::new();
    for (i, guide) in request.guides.iter().enumerate() {
        for part in guide.parts(i, domain.bounds())? {
            trails.extend(trim(part, &mut discs).into_iter().map(Trail::new));
        }
    }
    let wanted = Wanted::new(request.size, &domain, &discs, request.max_triangles)?;
    let profiles = line_profiles(&domain, &wanted)?;
    let mut met = Vec::new();
    for trail in &mut trails {
        met.extend(trail.meet(&domain, &wanted)?);
    }
    let forced = forced(&domain, &profiles, &discs, &met);
    let mut work = Work::new(&domain, &wanted, &profiles, &forced, &discs)?;
    for trail in &trails {
        work.weave(trail)?;
    }
    for passes in [4, 3] {
        work.refine()?;
        work.smooth(passes);
        work.rebuild()?;
    }
    work.smooth(2);
    work.rebuild()?;
    work.extract()
}
