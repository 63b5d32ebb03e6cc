//! Cutting a polyline into dashes, so that all backends draw the same pattern.

use super::scene::Px;

/// The drawn pieces of a polyline; `pattern` holds lengths drawn and skipped in turn.
pub(crate) fn dashes(points: &[Px], pattern: &[f64], width: f64) -> Vec<Vec<Px>> {
    if pattern.is_empty() {
        return vec![points.to_vec()];
    }
    let lengths: Vec<f64> = pattern.iter().map(|p| (p * width).max(0.5)).collect();
    let mut pieces: Vec<Vec<Px>> = Vec::new();
    let mut slot = 0;
    let mut left = lengths[0];
    let mut piece: Vec<Px> = points.first().copied().into_iter().collect();
    for pair in points.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        loop {
            let rest = (to.0 - from.0).hypot(to.1 - from.1);
            if rest <= left {
                left -= rest;
                if slot % 2 == 0 {
                    piece.push(to);
                }
                break;
            }
            let t = left / rest;
            from = (from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1));
            if slot % 2 == 0 {
                piece.push(from);
                pieces.push(std::mem::take(&mut piece));
            } else {
                piece = vec![from];
            }
            slot = (slot + 1) % lengths.len();
            left = lengths[slot];
        }
    }
    if slot % 2 == 0 && piece.len() > 1 {
        pieces.push(piece);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_turn_corners_and_keep_their_length() {
        let pieces = dashes(&[(0.0, 0.0), (5.0, 0.0), (5.0, 9.0)], &[3.0, 1.0], 2.0);
        assert_eq!(pieces[0], [(0.0, 0.0), (5.0, 0.0), (5.0, 1.0)]);
        assert_eq!(pieces[1], [(5.0, 3.0), (5.0, 9.0)]);
        assert_eq!(pieces.len(), 2);
    }

    #[test]
    fn unbroken_lines_stay_whole() {
        assert_eq!(dashes(&[(0.0, 0.0), (1.0, 0.0)], &[], 2.0).len(), 1);
    }
}
