use crate::Field;

/// Where further places would tell most, the best first: of the candidates the one where what kriging errs by is greatest, over
/// the half widths of the intervals at places and summed over the fields; then the same with that place sampled, as often as asked for. What
/// kriging errs by does not depend on what is found there.
#[must_use]
pub fn next_places(fields: &[Field], candidates: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let mut fields = fields.to_vec();
    let units: Vec<f64> = fields.iter().map(Field::mean_half_width).collect();
    let mut chosen = Vec::new();
    while chosen.len() < count {
        let score = |[x, y]: &[f64; 2]| {
            fields.iter().zip(&units).map(|(field, unit)| field.sd_at(*x, *y) / unit).sum::<f64>()
        };
        // The first of equals.
        let best = candidates.iter().map(|at| (score(at), *at)).reduce(|a, b| if b.0 > a.0 { b } else { a });
        let Some((score, at)) = best else { break };
        let with: Option<Vec<Field>> = fields.iter().map(|field| field.with_place(at[0], at[1])).collect();
        let Some(with) = with.filter(|_| score > 0.0) else { break };
        fields = with;
        chosen.push(at);
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Site;

    /// Of a square with places at its corners the middle is farthest from all; then the middles of its edges.
    #[test]
    fn the_emptiest_point_is_next() {
        let site = |x_m: f64, y_m: f64, low: f64| Site { x_m, y_m, low, high: low + 1.0 };
        let corners =
            [site(0.0, 0.0, 30.0), site(4.0, 0.0, 34.0), site(4.0, 4.0, 38.0), site(0.0, 4.0, 33.0)];
        let field = Field::new(&corners, 1.96).unwrap();
        let grid: Vec<[f64; 2]> =
            (0..=8).flat_map(|i| (0..=8).map(move |j| [0.5 * f64::from(i), 0.5 * f64::from(j)])).collect();
        let next = next_places(&[field], &grid, 2);
        assert_eq!(next[0], [2.0, 2.0]);
        let edges = [[2.0, 0.0], [0.0, 2.0], [4.0, 2.0], [2.0, 4.0]];
        assert!(edges.contains(&next[1]), "{next:?}");
    }
}
