//! Rays against the field: exact, by facets, skipping blocks that lie below the ray.

use super::field::{Facet, Field};

/// Where a ray meets the field.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hit {
    pub(super) point: [f64; 3],
    pub(super) slope: [f64; 2],
}

/// A ray on its way through the cells.
struct Walk<'a> {
    field: &'a Field,
    from: [f64; 3],
    direction: [f64; 3],
    /// The cell at the ray's present place.
    cell: [i64; 2],
    now: f64,
    /// Beyond here the ray is above or below everything.
    end: f64,
}

/// Blocks begun with: rays that start at the top mostly fall through a few of them.
const FIRST_LEVEL: usize = 4;

impl Field {
    /// The first facet seen from far above along a direction that points up, at a place of the
    /// plane.
    ///
    /// `None` for directions that do not rise.
    pub(super) fn seen(&self, towards: [f64; 3], place: [f64; 2]) -> Option<Hit> {
        if !(towards[2] > 0.0) {
            return None;
        }
        let start = [place[0], place[1], self.highest()];
        Walk::new(self, start, towards.map(|x| -x)).first_hit()
    }

    /// Whether a ray from a point of the field meets another facet.
    pub(super) fn blocked(&self, from: [f64; 3], towards: [f64; 3]) -> bool {
        // A period has mountains enough for every ray that does not rise.
        !(towards[2] > 0.0) || Walk::new(self, from, towards).first_hit().is_some()
    }
}

impl<'a> Walk<'a> {
    fn new(field: &'a Field, from: [f64; 3], direction: [f64; 3]) -> Self {
        let rises = direction[2] > 0.0;
        let last = if rises { field.highest() } else { field.lowest() - 1.0 };
        let cell = [from[0], from[1]].map(|x| x.floor() as i64);
        Self { field, from, direction, cell, now: 0.0, end: (last - from[2]) / direction[2] }
    }

    fn first_hit(&mut self) -> Option<Hit> {
        let mut level = FIRST_LEVEL.min(self.field.levels() - 1);
        while self.now < self.end {
            let (leave, axis) = self.exit(level);
            let low = self.height(self.now).min(self.height(leave));
            if low <= self.field.top(level, self.cell) {
                if level > 0 {
                    level -= 1;
                    continue;
                }
                if let Some(hit) = self.cell_hit(leave) {
                    return Some(hit);
                }
            }
            let Some(axis) = axis else { break };
            let parent = self.cell.map(|c| c >> (level + 1));
            self.step(level, leave, axis);
            let moved = parent != self.cell.map(|c| c >> (level + 1));
            if moved && level + 1 < self.field.levels() {
                level += 1;
            }
        }
        None
    }

    fn height(&self, t: f64) -> f64 {
        self.from[2] + t * self.direction[2]
    }

    /// When the ray leaves the block, and along which axis; none if it ends within.
    fn exit(&self, level: usize) -> (f64, Option<usize>) {
        let mut exit = (self.end, None);
        for axis in [0, 1] {
            let d = self.direction[axis];
            if d == 0.0 {
                continue;
            }
            let next = ((self.cell[axis] >> level) + i64::from(d > 0.0)) << level;
            let t = (next as f64 - self.from[axis]) / d;
            if t < exit.0 {
                exit = (t, Some(axis));
            }
        }
        (exit.0.max(self.now), exit.1)
    }

    /// Into the block beyond an axis' boundary. Cells are counted, not computed, so that rounding
    /// can neither stop a ray nor let it skip a block.
    fn step(&mut self, level: usize, leave: f64, axis: usize) {
        let other = 1 - axis;
        let block = self.cell.map(|c| c >> level);
        self.cell[axis] = if self.direction[axis] > 0.0 {
            (block[axis] + 1) << level
        } else {
            (block[axis] << level) - 1
        };
        let along = (self.from[other] + leave * self.direction[other]).floor() as i64;
        let first = block[other] << level;
        self.cell[other] = along.clamp(first, first + (1 << level) - 1);
        self.now = leave;
    }

    /// The first of the cell's facets that the ray goes through from above before it leaves.
    fn cell_hit(&self, leave: f64) -> Option<Hit> {
        let [x, y] = self.cell.map(|c| c as f64);
        let falls = Field::falls(self.cell);
        // Below the common edge it is negative.
        let side = |t: f64| {
            let u = self.from[0] + t * self.direction[0] - x;
            let v = self.from[1] + t * self.direction[1] - y;
            if falls { u + v - 1.0 } else { v - u }
        };
        let (first, last) = (side(self.now), side(leave));
        let facets = self.field.facets(self.cell);
        let facet = |side: f64| facets[usize::from(side > 0.0)];
        if first * last < 0.0 {
            let cross = self.now + (leave - self.now) * (first / (first - last));
            self.facet_hit(facet(first), [self.now, cross])
                .or_else(|| self.facet_hit(facet(last), [cross, leave]))
        } else {
            self.facet_hit(facet(first + last), [self.now, leave])
        }
    }

    /// The passage through a facet's plane from above, if it lies between two times.
    fn facet_hit(&self, facet: Facet, [from, to]: [f64; 2]) -> Option<Hit> {
        let above = |t: f64| {
            let u = self.from[0] + t * self.direction[0] - self.cell[0] as f64;
            let v = self.from[1] + t * self.direction[1] - self.cell[1] as f64;
            self.height(t) - (facet.height + facet.slope[0] * u + facet.slope[1] * v)
        };
        let (before, after) = (above(from), above(to));
        // Falling below the plane is meeting a front face; the ray was above it, but for rounding.
        if !(after < 0.0 && after < before) {
            return None;
        }
        let t = from + (to - from) * (before.max(0.0) / (before.max(0.0) - after));
        let point = [0, 1, 2].map(|k| self.from[k] + t * self.direction[k]);
        Some(Hit { point, slope: facet.slope })
    }
}

#[cfg(test)]
mod tests {
    use super::{Field, Hit};
    use crate::pattern::Jitter;
    use lobe::{Beckmann, Lobe, Real, Roughness};

    /// Height of the facets over a place.
    fn surface(field: &Field, [x, y]: [f64; 2]) -> f64 {
        let (i, j) = (x.floor(), y.floor());
        let (u, v) = (x - i, y - j);
        let cell = [i as i64, j as i64];
        let above = if Field::falls(cell) { u + v > 1.0 } else { v > u };
        let facet = field.facets(cell)[usize::from(above)];
        facet.height + facet.slope[0] * u + facet.slope[1] * v
    }

    /// A direction at an angle above the horizon, random around the axis.
    fn direction(elevation: f64, turn: f64) -> [f64; 3] {
        let (sin, cos) = elevation.to_radians().sin_cos();
        let (y, x) = (std::f64::consts::TAU * turn).sin_cos();
        [cos * x, cos * y, sin]
    }

    const ELEVATIONS: [f64; 6] = [0.3, 2.0, 10.0, 35.0, 70.0, 90.0];

    #[test]
    fn rays_from_above_meet_front_faces_and_what_small_steps_meet() {
        let field = Field::new(64, 5);
        let mut jitter = Jitter::new(1);
        for elevation in ELEVATIONS {
            for _ in 0..200 {
                let ([x, y], [turn, _]) = (jitter.next(), jitter.next());
                let towards = direction(elevation, turn);
                let place = [x * 200.0 - 100.0, y * 64.0];
                let Hit { point, slope } = field.seen(towards, place).unwrap();
                assert!((point[2] - surface(&field, [point[0], point[1]])).abs() < 1e-9);
                let facing = towards[2] - slope[0] * towards[0] - slope[1] * towards[1];
                assert!(facing > 0.0, "{elevation}: {facing}");
                // No facet is above the ray on its way there.
                let t = (field.highest() - point[2]) / towards[2];
                for k in 1..4000 {
                    let at: [f64; 3] =
                        [0, 1, 2].map(|i| point[i] + t * f64::from(k) / 4000.0 * towards[i]);
                    assert!(at[2] > surface(&field, [at[0], at[1]]) - 1e-9, "{elevation} {k}");
                }
            }
        }
    }

    #[test]
    fn blocked_rays_are_those_that_small_steps_find_blocked() {
        let field = Field::new(64, 6);
        let mut jitter = Jitter::new(2);
        let (mut blocked, mut count) = (0, 0);
        for elevation in [3.0, 15.0, 40.0] {
            for _ in 0..300 {
                let ([x, y], [turn, other]) = (jitter.next(), jitter.next());
                let hit = field.seen(direction(60.0, turn), [x * 64.0, y * 64.0]).unwrap();
                let towards = direction(elevation, other);
                if towards[2] < hit.slope[0] * towards[0] + hit.slope[1] * towards[1] {
                    continue; // Behind its own facet.
                }
                let end = (field.highest() - hit.point[2]) / towards[2];
                let steps = (end / 0.004) as i32;
                let lowest = (1..steps).map(|k| {
                    let at = [0, 1, 2].map(|i| hit.point[i] + 0.004 * f64::from(k) * towards[i]);
                    at[2] - surface(&field, [at[0], at[1]])
                });
                let lowest = lowest.fold(f64::INFINITY, f64::min);
                // What steps cannot tell is left out.
                if lowest.abs() > 1e-6 {
                    assert_eq!(field.blocked(hit.point, towards), lowest < 0.0, "{lowest}");
                    (blocked, count) = (blocked + i32::from(lowest < 0.0), count + 1);
                }
            }
        }
        assert!(blocked > 50 && count - blocked > 50, "{blocked} of {count}");
        assert!(field.blocked([0.0, 0.0, 9.0], [0.6, 0.0, -0.8]));
        assert!(!field.blocked([0.0, 0.0, 99.0], [0.6, 0.0, 0.8]));
    }

    #[test]
    fn directions_along_the_axes_and_into_the_ground_are_no_special_cases() {
        let field = Field::new(64, 7);
        for towards in [[0.6, 0.0, 0.8], [0.0, -0.6, 0.8], [0.0, 0.0, 1.0], [-0.6, -0.0, 0.8]] {
            for place in [[0.0, 0.0], [3.0, 7.5], [-0.25, 64.0]] {
                let Hit { point, .. } = field.seen(towards, place).unwrap();
                assert!((point[2] - surface(&field, [point[0], point[1]])).abs() < 1e-9);
            }
        }
        assert!(field.seen([0.8, 0.0, -0.6], [0.0; 2]).is_none());
        assert!(field.seen([1.0, 0.0, 0.0], [0.0; 2]).is_none());
    }

    /// Of the plane, the part that is seen: every ray sees m_z o_z / (m . o) of what it stands for.
    fn seen_part(fields: &[Field], sigma: [f64; 2], towards: [f64; 3], rays: u32) -> f64 {
        let mut jitter = Jitter::new(3);
        let stretched = [sigma[0] * towards[0], sigma[1] * towards[1], towards[2]];
        let mut sum = 0.0;
        for k in 0..rays as usize {
            let field = &fields[k % fields.len()];
            let place = jitter.next().map(|x| x * field.side() as f64);
            let s = field.seen(stretched, place).unwrap().slope;
            sum += towards[2] / (towards[2] - s[0] * stretched[0] - s[1] * stretched[1]);
        }
        sum / f64::from(rays)
    }

    #[test]
    fn the_part_seen_is_smith_s_masking_of_what_faces_the_viewer_or_a_little_less() {
        let fields: Vec<_> = (0..4).map(|seed| Field::new(512, 10 + seed)).collect();
        for (sigma, elevation) in [
            ([0.25; 2], 10.0),
            ([0.25; 2], 20.0),
            ([0.5; 2], 30.0),
            ([1.0; 2], 50.0),
            ([2.0; 2], 60.0),
            ([0.2, 1.6], 40.0),
        ] {
            for turn in [0.0, 0.1, 0.25] {
                let towards = direction(elevation, turn);
                let roughness = Roughness::from_sigma_rho(sigma[0], sigma[1], 0.0).unwrap();
                let smith = Beckmann::new(Lobe::centered(roughness).shape()).g1(towards);
                let deviation = (sigma[0] * towards[0]).hypot(sigma[1] * towards[1]);
                let facing = 1.0 - 0.5 * Real::erfc(towards[2] / deviation * 0.5_f64.sqrt());
                let ratio = seen_part(&fields, sigma, towards, 50_000) / (smith * facing);
                // Facets beside one that turns away lean as it does and stand in its shelter: what
                // faces the viewer is hidden more often than heights and slopes that know nothing
                // of each other would have it.
                assert!((0.9..1.02).contains(&ratio), "{sigma:?} {elevation} {turn}: {ratio}");
            }
        }
    }

    #[test]
    fn without_deviation_everything_is_seen() {
        let fields = [Field::new(64, 1)];
        for elevation in [0.3, 20.0] {
            let part = seen_part(&fields, [0.0; 2], direction(elevation, 0.2), 100);
            assert!((part - 1.0).abs() < 1e-12);
        }
    }
}
