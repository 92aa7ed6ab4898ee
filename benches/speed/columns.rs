//! Samples as engines keep them for a whole screen, an array for each number, and the loops over
//! them. Each loop is a function of its own, so that its code can be found and read.

use super::cases::{Case, EVALUATION, Limit};
use super::limit::{self, Operations};
use super::samples::{COUNT, Sample};
use lobe::Real;
use lobe::probe::{Counted, operations_of};
use std::hint::black_box;
use std::rc::Rc;

/// One number of every sample.
///
/// The padding keeps columns that lie one after the other off each other's cache sets.
pub(crate) type Column = [f32; COUNT + 80];

/// A column of zeros, to be copied.
pub(crate) static EMPTY: Column = [0.0; COUNT + 80];

/// One sample in one place: both directions and two parameters.
pub(crate) type Record = [f32; 8];

/// Directions to viewer and light.
#[derive(Clone, Copy)]
pub(crate) struct Pair<R> {
    pub(crate) wo: [R; 3],
    pub(crate) wi: [R; 3],
}

/// Columns of what `pick` takes of each sample.
pub(crate) fn columns<const N: usize>(
    samples: &[Sample],
    pick: impl Fn(&Sample) -> [f32; N],
) -> Rc<[Column; N]> {
    let mut columns: Box<[Column; N]> = vec![EMPTY; N].try_into().expect("N columns");
    for (i, sample) in samples.iter().enumerate() {
        for (column, value) in columns.iter_mut().zip(pick(sample)) {
            column[i] = value;
        }
    }
    columns.into()
}

/// Both directions of a sample.
pub(crate) fn directions(sample: &Sample) -> [f32; 6] {
    let ([a, b, c], [d, e, f]) = (sample.wo, sample.wi);
    [a, b, c, d, e, f]
}

/// The samples that all rows share.
#[derive(Clone)]
pub(crate) struct Inputs {
    pub(crate) samples: Rc<[Sample]>,
    pub(crate) directions: Rc<[Column; 6]>,
}

impl Inputs {
    /// Of these samples.
    pub(crate) fn new(samples: Vec<Sample>) -> Self {
        let directions = columns(&samples, directions);
        Self { samples: samples.into(), directions }
    }
}

/// The loop of a row: directions and parameters from columns, and what was baked from an array.
#[inline(never)]
fn loop_over_columns<const N: usize, B>(
    directions: &[Column; 6],
    parameters: &[Column; N],
    baked: &[B; COUNT],
    out: &mut Column,
    f: impl Fn(Pair<f32>, [f32; N], &B) -> f32,
) {
    for (i, (out, baked)) in out.iter_mut().zip(baked).enumerate() {
        let [a, b, c, d, e, g] = std::array::from_fn(|k| directions[k][i]);
        let pair = Pair { wo: [a, b, c], wi: [d, e, g] };
        *out = f(pair, std::array::from_fn(|k| parameters[k][i]), baked);
    }
}

/// The loop of a row over records.
#[inline(never)]
fn loop_over_records(
    records: &[Record; COUNT],
    out: &mut Column,
    f: impl Fn(Pair<f32>, [f32; 2]) -> f32,
) {
    for (out, &[a, b, c, d, e, g, x, y]) in out.iter_mut().zip(records) {
        *out = f(Pair { wo: [a, b, c], wi: [d, e, g] }, [x, y]);
    }
}

/// What `f` does for one sample, in the mean over every sixteenth, with the numbers that it reads
/// and writes.
fn count(
    samples: &[Sample],
    numbers: usize,
    f: impl Fn(&Sample, Pair<Counted>) -> Counted,
) -> Operations {
    let some: Vec<&Sample> = samples.iter().step_by(16).collect();
    let ((), done) = operations_of(|| {
        for sample in &some {
            let lift = |w: [f32; 3]| w.map(|x| Counted::lit(x.into()));
            black_box(f(sample, Pair { wo: lift(sample.wo), wi: lift(sample.wi) }));
        }
    });
    let mean = |sum: u64| (sum as usize + some.len() / 2) / some.len();
    Operations { divisions: mean(done.divisions), roots: mean(done.roots), loads: numbers }
}

impl Inputs {
    /// A row whose parameters, `pick`ed of each sample, become a shape inside the loop; from a
    /// function of f32, and the same of numbers that count.
    pub(crate) fn row<const N: usize>(
        &self,
        name: &'static str,
        pick: fn(&Sample) -> [f32; N],
        f: impl Fn(Pair<f32>, [f32; N]) -> f32 + 'static,
        counted: impl Fn(Pair<Counted>, [Counted; N]) -> Counted,
    ) -> Case {
        let counted = |pair, x: [Counted; N], (): &()| counted(pair, x);
        self.baked_row(name, pick, |_| (), move |pair, x, (): &()| f(pair, x), |_| (), counted)
    }

    /// A row for which `bake` has made something of each sample beforehand.
    pub(crate) fn baked_row<const N: usize, B: 'static, C>(
        &self,
        name: &'static str,
        pick: fn(&Sample) -> [f32; N],
        bake: fn(&Sample) -> B,
        f: impl Fn(Pair<f32>, [f32; N], &B) -> f32 + 'static,
        bake_counted: fn(&Sample) -> C,
        counted: impl Fn(Pair<Counted>, [Counted; N], &C) -> Counted,
    ) -> Case {
        let numbers = 6 + N + size_of::<B>() / size_of::<f32>();
        let operations = count(&self.samples, numbers, |sample, pair| {
            // What was baked costs nothing here.
            let (baked, _) = operations_of(|| bake_counted(sample));
            counted(pair, pick(sample).map(|x| Counted::lit(x.into())), &baked)
        });
        let limit = Limit { operations, pass: limit::pass(operations) };
        Case { limit: Some(limit), ..self.uncounted_row(name, pick, bake, f) }
    }

    /// A row without a count.
    pub(crate) fn uncounted_row<const N: usize, B: 'static>(
        &self,
        name: &'static str,
        pick: fn(&Sample) -> [f32; N],
        bake: fn(&Sample) -> B,
        f: impl Fn(Pair<f32>, [f32; N], &B) -> f32 + 'static,
    ) -> Case {
        let parameters = columns(&self.samples, pick);
        let baked: Box<[B]> = self.samples.iter().map(bake).collect();
        let directions = self.directions.clone();
        let mut out: Box<Column> = Box::new(EMPTY);
        let pass = move || {
            let baked: &[B; COUNT] = baked.as_ref().try_into().expect("all samples");
            let (directions, parameters) = (black_box(&*directions), black_box(&*parameters));
            loop_over_columns(directions, parameters, black_box(baked), &mut out, &f);
            black_box(&out);
        };
        Case { group: EVALUATION, name, pass: Box::new(pass), limit: None }
    }

    /// Records with two parameters.
    pub(crate) fn records(&self, pick: fn(&Sample) -> [f32; 2]) -> Box<[Record; COUNT]> {
        let record = |sample: &Sample| {
            let ([a, b, c, d, e, f], [x, y]) = (directions(sample), pick(sample));
            [a, b, c, d, e, f, x, y]
        };
        let records: Vec<Record> = self.samples.iter().map(record).collect();
        records.try_into().expect("all samples")
    }

    /// A row over records in place of columns.
    pub(crate) fn record_row(
        &self,
        name: &'static str,
        pick: fn(&Sample) -> [f32; 2],
        f: impl Fn(Pair<f32>, [f32; 2]) -> f32 + 'static,
        counted: impl Fn(Pair<Counted>, [Counted; 2]) -> Counted,
    ) -> Case {
        let operations = count(&self.samples, 8, |sample, pair| {
            counted(pair, pick(sample).map(|x| Counted::lit(x.into())))
        });
        let records = self.records(pick);
        let mut out: Box<Column> = Box::new(EMPTY);
        let pass = move || {
            loop_over_records(black_box(&*records), &mut out, &f);
            black_box(&out);
        };
        let limit = Some(Limit { operations, pass: limit::pass(operations) });
        Case { group: EVALUATION, name, pass: Box::new(pass), limit }
    }
}
