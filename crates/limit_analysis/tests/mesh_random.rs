//! Random polygons, random guides, random sizes: always a valid mesh.

mod mesh_common;

use mesh_common::{check, mesh, mesh_with_fans, plate, polygon};
use proptest::prelude::*;
use soilctl_certificate::{Line, LineUse, Place};
use soilctl_limit_analysis::mesh::{Fan, Guide, SizeField};

fn guides() -> impl Strategy<Value = Vec<Guide>> {
    let point = (-2.5..2.5f64, -2.5..2.5f64).prop_map(|(x, y)| [x, y]);
    let guide = prop::collection::vec(point, 0..6).prop_map(|points| Guide { points });
    prop::collection::vec(guide, 0..6)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn stars(radii in prop::collection::vec(0.2..2.0f64, 3..25), turn in 0.0..1.0f64, guides in guides(), size in 0.05..3.0f64) {
        let n = radii.len();
        let at = |i: usize| std::f64::consts::TAU * (i as f64 + turn) / n as f64;
        let points: Vec<_> = radii.iter().enumerate().map(|(i, r)| [r * at(i).cos(), r * at(i).sin()]).collect();
        let outline = polygon(&points);
        let made = mesh(&outline, &guides, &|_| size).unwrap();
        check(&outline, &made);
        // The least angle that the outline or a guide forces is not known; no angle may be next to nothing.
        prop_assert!(made.quality().min_angle_deg > 0.5, "{:?}", made.quality());
        prop_assert!(made.quality().longest_edge < 2.2 * size);
    }

    #[test]
    fn fans(radii in prop::collection::vec(0.2..2.0f64, 3..12), guides in guides(), size in 0.05..3.0f64, radius in 0.01..1.0f64, angle in 0.1..1.5f64, to_corner in 0..12usize) {
        let n = radii.len();
        let at = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let mut outline = polygon(&radii.iter().enumerate().map(|(i, r)| [r * at(i).cos(), r * at(i).sin()]).collect::<Vec<_>>());
        outline.points.push([0.3 * radii[0], 0.01]);
        outline.lines.push(Line { from: 0, to: n });
        let used = |forward| LineUse { line: n, forward };
        outline.regions[0].loops[0].splice(0..0, [used(true), used(false)]);
        let mut guides = guides;
        for guide in guides.iter_mut().step_by(2) {
            guide.points.insert(0, outline.points[to_corner % (n + 1)]);
        }
        let fans: Vec<Fan> = (0..=n).step_by(1 + to_corner % 3).map(|point| Fan { point, radius, angle }).collect();
        let made = mesh_with_fans(&outline, &guides, &fans, &|_| size).unwrap();
        check(&outline, &made);
        for fan in &fans {
            let apex = made.vertices.iter().position(|v| v.place == Place::Corner { point: fan.point }).unwrap();
            let far = |v: usize| {
                let [a, b] = [v, apex].map(|v| made.vertices[v].position);
                (a[0] - b[0]).hypot(a[1] - b[1])
            };
            let mut spokes: Vec<f64> = made.triangles.iter().filter(|t| t.corners.contains(&apex)).flat_map(|t| t.corners).filter(|&v| v != apex).map(far).collect();
            spokes.sort_by(f64::total_cmp);
            let (least, most) = (spokes[0], spokes[spokes.len() - 1]);
            prop_assert!(most - least < 1e-9 * most && most <= radius * (1.0 + 1e-9), "{least} {most}");
        }
        prop_assert!(made.quality().min_angle_deg > 0.5, "{:?}", made.quality());
    }

    #[test]
    fn slits_to_the_centre(radii in prop::collection::vec(0.5..2.0f64, 3..12), depth in 0.05..1.0f64, size in 0.05..1.0f64) {
        let n = radii.len();
        let at = |i: usize| std::f64::consts::TAU * i as f64 / n as f64;
        let mut outline = polygon(&radii.iter().enumerate().map(|(i, r)| [r * at(i).cos(), r * at(i).sin()]).collect::<Vec<_>>());
        outline.points.push([radii[0] * (1.0 - depth), 0.01]);
        outline.lines.push(Line { from: 0, to: n });
        let used = |forward| LineUse { line: n, forward };
        outline.regions[0].loops[0].splice(0..0, [used(true), used(false)]);
        let made = mesh(&outline, &[], &|_| size).unwrap();
        check(&outline, &made);
    }

    #[test]
    fn rough_fields(sizes in prop::collection::vec(-3.0..0.5f64, 60), guides in guides()) {
        let points: Vec<[f64; 2]> = (0..60).map(|i| [-3.0 + (i % 10) as f64 * 1.5, -3.0 + (i / 10) as f64 * 0.6]).collect();
        let sizes: Vec<f64> = sizes.iter().map(|s| 10f64.powf(*s)).collect();
        let field = SizeField::new(&points, &sizes, 0.01, 1.0, 0.3).unwrap();
        let outline = plate([0.5, -0.8]);
        let made = mesh(&outline, &guides, &|p| field.size(p)).unwrap();
        check(&outline, &made);
        prop_assert!(made.quality().min_angle_deg > 8.0, "{:?}", made.quality());
        // Without grading: nearest sample only.
        let nearest = |p: [f64; 2]| {
            let d = |i: usize| (points[i][0] - p[0]).hypot(points[i][1] - p[1]);
            sizes[(0..60).min_by(|&a, &b| d(a).total_cmp(&d(b))).unwrap()].clamp(0.1, 3.0)
        };
        let rough = mesh(&outline, &[], &nearest).unwrap();
        check(&outline, &rough);
        prop_assert!(rough.quality().min_angle_deg > 20.0, "{:?}", rough.quality());
    }
}
