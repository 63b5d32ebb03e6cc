//! t
use soilctl_earth_pressure::model;
use soilctl_estimator::*;
use soilctl_soil::*;
fn main() {
    for (id, n, rel, lo, hi) in [("thesis-ub", 4, 0.08, 22.0, 24.0), ("thesis-ub", 1, 0.08, 22.0, 24.0), ("thesis-ub", 1, 0.005, 12.0, 15.8), ("coulomb", 1, 0.005, 12., 15.8), ("table", 2, 0.05, 7.6, 10.6), ("chen", 4, 0.08, 22.0, 24.0)] {
        let m = model(id).unwrap();
        let obs: Vec<_> = [70.0, 80.0, 90.0, 100.0][..n].iter().zip([3.78, 5.74, 8.94, 13.1]).map(|(a, f)| {
            let a = Angle::from_degrees(*a);
            let p = Plate::new(a, Angle::ZERO, 0.0254 * a.sin(), 0.127).unwrap();
            Observation::new("x", p, f, rel * f).unwrap()
        }).collect();
        let s = Setup::new(&*m, obs, (lo, hi));
        let t = std::time::Instant::now();
        let e = estimate(&s).unwrap();
        println!("{id} {n} {rel}: {:?} vertices {}", t.elapsed(), e.region.polygons().iter().flatten().map(Vec::len).sum::<usize>());
        let t = std::time::Instant::now();
        let e = section(&s, lo + 0.5).unwrap();
        println!("   section {:?} {}", t.elapsed(), e.polygons().len());
    }
}
