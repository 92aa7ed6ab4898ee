//! How far two parallelograms around one center cover each other.

use lobe::Footprint;

type Point = [f64; 2];

/// Area of non-overlap over the larger area, from 0 for equal parallelograms to 2 for disjoint ones
/// of one area (Kaplanyan et al. 2016, Fig. 7); of two without area 0 if they are the same line,
/// else 1.
pub(crate) fn non_overlap(a: &Footprint<f32>, b: &Footprint<f32>) -> f64 {
    let (a, b) = (corners(a), corners(b));
    let (area_a, area_b) = (area(&a), area(&b));
    let larger = area_a.max(area_b);
    if !(larger > 0.0 && larger.is_finite()) {
        return if a == b { 0.0 } else { 1.0 };
    }
    let common = clipped(a.to_vec(), &b).min(area_a).min(area_b);
    (area_a + area_b - 2.0 * common) / larger
}

/// Counter-clockwise.
fn corners(footprint: &Footprint<f32>) -> [Point; 4] {
    let [u, v] = [footprint.u, footprint.v].map(|side| side.map(|x| 0.5 * f64::from(x)));
    let at = |i: f64, j: f64| [i * u[0] + j * v[0], i * u[1] + j * v[1]];
    let corners = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
    if cross(u, v) >= 0.0 { corners } else { [corners[0], corners[3], corners[2], corners[1]] }
}

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn area(polygon: &[Point]) -> f64 {
    let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
    0.5 * edges.map(|(a, b)| cross(*a, *b)).sum::<f64>()
}

/// Area of a convex polygon within a convex window (Sutherland & Hodgman 1974).
fn clipped(mut polygon: Vec<Point>, window: &[Point; 4]) -> f64 {
    for k in 0..4 {
        let (from, to) = (window[k], window[(k + 1) % 4]);
        let edge = [to[0] - from[0], to[1] - from[1]];
        let inside = |p: Point| cross(edge, [p[0] - from[0], p[1] - from[1]]);
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for (index, &point) in polygon.iter().enumerate() {
            let before = polygon[(index + polygon.len() - 1) % polygon.len()];
            let (was, is) = (inside(before), inside(point));
            if (was < 0.0) != (is < 0.0) {
                let t = was / (was - is);
                kept.push([0, 1].map(|axis| before[axis] + t * (point[axis] - before[axis])));
            }
            if is >= 0.0 {
                kept.push(point);
            }
        }
        polygon = kept;
    }
    area(&polygon).max(0.0)
}

#[cfg(test)]
mod tests {
    use super::non_overlap;
    use lobe::Footprint;

    fn of(u: [f32; 2], v: [f32; 2]) -> Footprint<f32> {
        Footprint::from_slopes(u, v)
    }

    #[test]
    fn equal_halved_and_turned_parallelograms() {
        let square = of([1.0, 0.0], [0.0, 1.0]);
        assert_eq!(non_overlap(&square, &square), 0.0);
        // Signs and order of the sides do not matter.
        assert_eq!(non_overlap(&square, &of([0.0, -1.0], [1.0, 0.0])), 0.0);
        assert!((non_overlap(&square, &of([0.5, 0.0], [0.0, 1.0])) - 0.5).abs() < 1e-12);
        // A square and itself turned by 45 degrees share 2 sqrt(2) - 2 of the area.
        let r = 0.5_f32.sqrt();
        let turned = non_overlap(&square, &of([r, r], [-r, r]));
        assert!((turned - (2.0 - 2.0 * (8.0_f64.sqrt() - 2.0))).abs() < 1e-6, "{turned}");
        let (wide, tall) = (of([1.0, 0.0], [0.0, 1e-3]), of([0.0, 1.0], [1e-3, 0.0]));
        assert!(non_overlap(&wide, &tall) > 1.9);
    }

    #[test]
    fn lines_and_points_have_no_area_to_share() {
        let (line, other) = (of([1.0, 0.0], [0.0; 2]), of([0.0, 1.0], [0.0; 2]));
        assert_eq!(non_overlap(&line, &line), 0.0);
        assert_eq!(non_overlap(&line, &other), 1.0);
        assert_eq!(non_overlap(&line, &of([1.0, 0.0], [0.0, 1.0])), 1.0);
    }
}
