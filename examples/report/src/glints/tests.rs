use super::cells::Visited;
use super::contest::contests;
use super::count::{Instructions, per_cell};
use super::gain::Gain;
use super::hall::Hall;
use super::material::{MATERIALS, Material, snow};
use super::model::{Made, Model, Seen};
use super::moments::{Moments, distance};
use super::points::Points;
use super::sample::{Light, Pixel, Setting};
use super::speed::{Curve, Load, Speed};

/// Details as rough as they need to be for few to suffice.
const ROUGH: Material = Material { name: "", alpha: 0.5, fractions: [0.3, 0.2], details: 60.0 };

fn setting(material: &Material, aspect: f64, half: f64) -> Setting<'_> {
    Setting { material, aspect, half, light: Light::Point, octave: None }
}

#[test]
fn points_have_the_mean_and_the_variance_of_their_closed_form() {
    const COUNT: u64 = 6000;
    for (aspect, half) in [(1.0, 0.0), (4.0, 1.0), (16.0, 0.5)] {
        let setting = setting(&ROUGH, aspect, half);
        let slope = [half * ROUGH.alpha, 0.0];
        let smooth = (-half * half).exp() / (std::f64::consts::PI * ROUGH.alpha * ROUGH.alpha);
        let pixel = |index: u64| {
            let pixel = Pixel::random(aspect, None, index);
            let points = Points::new(&ROUGH, ROUGH.density(pixel.area), index);
            points.slope_pdf(&pixel.patch, slope) / smooth
        };
        let points: Vec<_> = (0..COUNT).map(pixel).collect();
        // The same by thinning, for any number of details.
        let drawn = setting.true_ratios(COUNT, 0);
        let law = setting.true_variance(1);
        for moments in [&points, &drawn].map(|values| Moments::of(values)) {
            let Moments { mean, mean_error, variance, variance_error } = moments;
            assert!((mean - 1.0).abs() < 4.0 * mean_error, "{aspect} {half}: {moments:?}");
            assert!((variance - law).abs() < 4.0 * variance_error, "{moments:?}, law {law}");
        }
        // As two samples of one distribution are.
        let noise = distance(&setting.true_ratios(COUNT, 1), &drawn);
        let apart = distance(&points, &drawn);
        assert!(apart < 4.0 * noise.max(0.01), "{aspect} {half}: {apart}, noise {noise}");
    }
}

#[test]
fn a_pixel_s_points_are_those_of_its_halves() {
    for index in 0..50 {
        let Pixel { patch, area, .. } = Pixel::random(3.0, None, index);
        let points = Points::new(&ROUGH, ROUGH.density(area), 7);
        let whole = points.slope_pdf(&patch, [0.1, 0.2]);
        let halves = [-0.25, 0.25].map(|part| {
            let uv = [0, 1].map(|k| patch.uv[k] + part * patch.up[k]);
            let half = lobe::material::cells::Patch { uv, up: patch.up.map(|x| 0.5 * x), ..patch };
            points.slope_pdf(&half, [0.1, 0.2])
        });
        let sum = 0.5 * (halves[0] + halves[1]);
        assert!((sum - whole).abs() < 1e-9 * whole.max(1.0), "{sum} {whole}");
    }
}

#[test]
fn grooves_have_the_variance_of_their_closed_form() {
    let grooves = MATERIALS[5].with_details(20.0);
    assert!(grooves.is_groove());
    for aspect in [1.0, 8.0] {
        let setting = setting(&grooves, aspect, 0.5);
        let Moments { mean, mean_error, variance, variance_error } =
            Moments::of(&setting.true_ratios(20_000, 0));
        let law = setting.true_variance(20_000);
        assert!((mean - 1.0).abs() < 4.0 * mean_error, "{mean} {mean_error}");
        assert!((variance - law).abs() < 4.0 * variance_error + 0.01 * law, "{variance}, {law}");
    }
}

#[test]
fn cells_are_bounded_and_published_loops_lose_long_pixels() {
    for aspect in [1.0, 8.0, 16.0, 64.0, 1e3] {
        let Visited { default, published, lost, .. } = Visited::of(aspect, 500).unwrap();
        assert!(default[0] >= 4.0 && default[1] <= 104.0, "{default:?}");
        assert!(published[0] >= 4.0 && published[1] <= 60.0, "{published:?}");
        if aspect <= 8.0 {
            assert!(lost[1] < 1e-12, "{aspect}: {lost:?}");
        } else {
            assert!(lost[0] > 0.01 && lost[1] < 0.5, "{aspect}: {lost:?}");
        }
    }
}

#[test]
fn the_default_s_mean_is_right_within_its_noise_and_its_variance_within_its_law() {
    const COUNT: u64 = 4000;
    for (material, aspect, half) in [(1, 1.0, 0.0), (3, 4.0, 1.0), (4, 16.0, 1.0), (5, 4.0, 1.0)] {
        let setting = setting(&MATERIALS[material], aspect, half);
        let Moments { mean, mean_error, variance, variance_error } =
            Moments::of(&setting.ratios(Model::Default, COUNT).unwrap());
        assert!((mean - 1.0).abs() < 4.0 * mean_error, "{material}: {mean} +- {mean_error}");
        let [apart, together] = setting.law(COUNT).unwrap();
        let (noise, name) = (4.0 * variance_error, MATERIALS[material].name);
        assert!(variance > apart - noise, "{name}: {variance}, law {apart}");
        assert!(variance < 1.04 * together + noise, "{name}: {variance}, law {together}");
    }
}

#[test]
fn published_means_are_cut_at_grazing_half_vectors_and_hazy_under_the_sun() {
    let mean = |material: usize, half: f64, light: Light| {
        let setting = Setting { light, ..setting(&MATERIALS[material], 1.0, half) };
        Moments::of(&setting.ratios(Model::Published, 4000).unwrap()).mean
    };
    assert!(mean(4, 1.0, Light::Point) < 0.6);
    assert!(mean(2, 2.0, Light::Sun) > 1.05 && mean(2, 2.0, Light::Point) < 1.05);
}

#[test]
fn published_sizes_gain_energy_and_ours_do_not() {
    let Gain { published, default, .. } = Gain::of(1.0, 1.0, 200_000, 0).unwrap();
    assert!(published.mean > 1.5, "{published:?}");
    assert!((default.mean - 1.0).abs() < 4.0 * default.mean_error, "{default:?}");
}

#[test]
fn every_model_is_smooth_where_details_are_many() {
    let many = snow("", 1e16);
    for index in 0..20 {
        let Pixel { patch, area, .. } = Pixel::random(4.0, None, index);
        let made = Made::<f64>::new(&many, area, 0).unwrap();
        let up = [0.0, 0.0, 1.0];
        let seen = Seen { patch, wo: up, wi: up, radius: 0.0 };
        for model in [Model::Smooth, Model::Default, Model::Varied, Model::Four, Model::Published] {
            let ratio = made.ratio(model, &seen);
            assert!((ratio - 1.0).abs() < 0.02, "{model:?}: {ratio}");
        }
    }
}

#[test]
fn the_default_is_nearer_to_the_truth_than_its_parts_and_the_smooth_lobe() {
    let contests = contests(4000, Load { pixels: 2, rounds: 1 }).unwrap();
    for contest in &contests {
        let of = |model: Model| contest.of(model).unwrap().distance;
        let one = of(Model::Default);
        assert!(of(Model::Smooth) > 3.0 * one && of(Model::Smooth) > 3.0 * of(Model::Four));
        // All points are the truth; a part of them is not.
        let [.., part, all] = &contest.points[..] else { panic!("shares") };
        assert!(all.distance < 4.0 * contest.noise && part.distance > one, "{contest:?}");
        assert!(all.time > 0.0 && part.time > 0.0);
    }
}

#[test]
fn a_cell_costs_the_same_in_any_pixel_and_less_than_all() {
    let counted = per_cell().unwrap();
    for cost in &counted {
        assert!(cost.cell.total() > 10.0 && cost.cell.total() < 300.0, "{cost:?}");
        assert!(cost.pixel.total() > cost.cell.total());
    }
    let Instructions { cell, varied, whole } = Instructions::counted().unwrap();
    assert!(varied[0] < cell[0] && cell[0] < whole[0]);
    assert!(cell.iter().all(|&count| count > 50) && cell[1] < cell[0]);
}

#[test]
fn every_point_of_the_charts_is_timed() {
    let speed = Speed::measured(Load { pixels: 4, rounds: 1 }).unwrap();
    assert!((speed.aspects[2] - 16.0).abs() < 1e-3);
    let cells = speed.by_cells.iter().map(|curve| &curve.points);
    assert!(cells.clone().all(|points| points.is_sorted_by(|a, b| a[0] < b[0])));
    let details = speed.by_details.iter().map(|curve| &curve.points);
    for (points, count) in
        cells.map(|p| (p, 8)).chain(details.map(|p| (p, 11))).chain([(&speed.points, 5)])
    {
        assert!(points.len() == count && points.iter().all(|point| point[1] > 0.0), "{points:?}");
    }
}

#[test]
fn lines_are_least_squares() {
    let curve = |points: &[[f64; 2]]| {
        Curve { model: Model::Default, aspect: 1.0, points: points.to_vec() }.line()
    };
    assert_eq!(curve(&[[1.0, 5.0], [2.0, 7.0], [4.0, 11.0]]), (2.0, 0.0));
    // The line lies at 7/3, the middle point is 2/7 above it.
    let (slope, off) = curve(&[[0.0, 2.0], [1.0, 3.0], [2.0, 2.0]]);
    assert!(slope.abs() < 1e-12 && (off - 2.0 / 7.0).abs() < 1e-12, "{slope} {off}");
}

#[test]
fn the_hall_is_steep_in_front_and_grazing_behind() {
    let hall = Hall::seen(96).unwrap();
    let at = |x: usize, y: usize| hall.cells[y * hall.size.width + x];
    assert!(hall.cells.iter().all(|&cells| cells == 0.0 || (4.0..=104.0).contains(&cells)));
    let front: f64 = (0..96).map(|x| at(x, hall.size.height - 1)).sum::<f64>() / 96.0;
    let most = hall.cells.iter().copied().fold(0.0, f64::max);
    assert!(front > 7.0 && front < 30.0 && most > 60.0, "{front} {most}");
    // The sky between the walls.
    assert!(hall.cells.contains(&0.0) && hall.lost.iter().any(|&lost| lost > 0.05));
}

#[test]
fn distances_are_those_of_sorted_values() {
    assert_eq!(distance(&[3.0, 1.0], &[1.0, 2.0]), 0.5);
    assert_eq!(distance(&[2.0, 1.0], &[1.0, 2.0]), 0.0);
    let moments = Moments::of(&[1.0, 3.0]);
    assert_eq!((moments.mean, moments.variance), (2.0, 0.25));
}
