//! What the harness promises: bits survive, exact mode is exact, and `kept` protects shipped code.

use lobe::wgsl::{Item, source};
use lobe_report::spirv;

use lobe_gpu::{Driver, Gpu, Job, Mode, Painter, exact, timing, tools};

/// Items of the comparisons with Rust.
const COUNT: usize = 100_000;

/// The WGSL port's own, under a short name.
fn kept() -> String {
    source(&[Item::ScalarReal]) + "\nfn kept(x: f32) -> f32 { return lobe_kept(x); }\n"
}

/// Floats of both signs and magnitudes from 2^-20 to 2^20: no result leaves the normal range.
fn random(count: usize) -> Vec<f32> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        let bits = (state >> 32) as u32;
        let exponent = 107 + (state >> 20) as u32 % 41;
        f32::from_bits(bits & 0x807f_ffff | exponent << 23)
    };
    (0..count).map(|_| next()).collect()
}

/// Number of outputs of `job` whose bits differ from Rust's.
fn differing(gpu: &'static Gpu, mode: Mode, job: Job, rust: impl Fn(&[f32]) -> Vec<f32>) -> usize {
    let inputs = random(COUNT * job.inputs);
    let expected = inputs.chunks(job.inputs).flat_map(rust);
    let outputs = job.run(gpu, mode, &inputs).unwrap();
    assert_eq!(outputs.len(), COUNT * job.outputs);
    outputs.iter().zip(expected).filter(|(got, want)| got.to_bits() != want.to_bits()).count()
}

fn two_sum(item: &[f32]) -> Vec<f32> {
    let [a, b] = [item[0], item[1]];
    let sum = a + b;
    let b_part = sum - a;
    vec![sum, (a - (sum - b_part)) + (b - b_part)]
}

#[test]
fn lavapipe_is_there() {
    assert_eq!(Gpu::lavapipe().kind(), Driver::Lavapipe);
    for gpu in Gpu::every() {
        println!("{:?}: {}, timestamps {}", gpu.kind(), gpu.name(), gpu.has_timestamps());
    }
}

#[test]
fn all_bits_survive_a_job() {
    let mut bits = vec![
        0x0000_0000,
        0x8000_0000,
        0x0000_0001,
        0x807f_ffff,
        0x7f80_0000,
        0xff80_0000,
        0x7fc0_0000,
        0xffff_ffff,
        0x7f80_0001,
        0xffa5_5a5a,
        0x3f80_0000,
    ];
    bits.extend(random(1000).iter().map(|x| x.to_bits().wrapping_mul(0x9e37_79b9)));
    let inputs: Vec<f32> = bits.iter().copied().map(f32::from_bits).collect();
    for gpu in Gpu::every() {
        for mode in [Mode::Shipped, Mode::Exact] {
            for body in ["put(0, at(0));", "put_bits(0, bits_at(0));"] {
                let job = Job { library: "", body, inputs: 1, outputs: 1, dictionary: &[] };
                let outputs = job.run(gpu, mode, &inputs).unwrap();
                let echo: Vec<u32> = outputs.iter().map(|x| x.to_bits()).collect();
                assert!(echo == bits, "{} {mode:?} {body}", gpu.name());
            }
        }
    }
}

#[test]
fn items_beyond_one_dispatch_are_chunked() {
    let gpu = Gpu::lavapipe();
    let body = "put(0, at(1) + 1.0); put_bits(1, item); put(2, at(0));";
    let kernel = Job { library: "", body, inputs: 2, outputs: 3, dictionary: &[] }
        .compile(gpu, Mode::Shipped)
        .unwrap();
    assert!(kernel.most_items() > 1 << 20);
    let items = kernel.most_items() + 3;
    let inputs: Vec<f32> = (0..2 * items).map(|k| (k % 1009) as f32).collect();
    let outputs = kernel.run(&inputs);
    assert_eq!(outputs.len(), 3 * items);
    for (k, output) in outputs.chunks(3).enumerate() {
        let wanted = [inputs[2 * k + 1] + 1.0, inputs[2 * k]];
        assert_eq!([output[0], output[2]], wanted, "item {k}");
        assert_eq!(output[1].to_bits() as usize, k % kernel.most_items());
    }
    assert!(kernel.run(&[]).is_empty());
}

/// Expressions that drivers rewrite, with the same in Rust.
type Rewritten = (&'static str, usize, usize, fn(&[f32]) -> Vec<f32>);

const REWRITTEN: [Rewritten; 6] = [
    (
        "let a = at(0); let b = at(1); let s = a + b; let t = s - a;
         put(0, s); put(1, (a - (s - t)) + (b - t));",
        2,
        2,
        two_sum,
    ),
    ("put(0, at(0) * at(1) + at(0) * at(2));", 3, 1, |x| vec![x[0] * x[1] + x[0] * x[2]]),
    ("put(0, (at(0) + 0.1) + 0.2);", 1, 1, |x| vec![(x[0] + 0.1) + 0.2]),
    ("put(0, 3.0 * (at(0) * 0.7));", 1, 1, |x| vec![3.0 * (x[0] * 0.7)]),
    ("put(0, at(0) / 3.0);", 1, 1, |x| vec![x[0] / 3.0]),
    ("let r = sqrt(abs(at(0))); put(0, r * r);", 1, 1, |x| {
        let root = x[0].abs().sqrt();
        vec![root * root]
    }),
];

/// Whether the driver rounds all operations of `body` correctly: real GPUs may miss quotients and
/// roots by an ulp or two.
fn rounds(gpu: &Gpu, body: &str) -> bool {
    gpu.kind() != Driver::Hardware || !(body.contains('/') || body.contains("sqrt"))
}

#[test]
fn exact_mode_rounds_as_rust_does() {
    for gpu in Gpu::every() {
        for (body, inputs, outputs, rust) in REWRITTEN.into_iter().filter(|it| rounds(gpu, it.0)) {
            let job = Job { library: "", body, inputs, outputs, dictionary: &[] };
            let shipped = differing(gpu, Mode::Shipped, job, rust);
            let exact = differing(gpu, Mode::Exact, job, rust);
            println!("{}: shipped {shipped}, exact {exact} of {COUNT} differ: {body}", gpu.name());
            assert_eq!(exact, 0, "{}: {body}", gpu.name());
        }
    }
}

#[test]
fn exact_mode_is_needed() {
    // If lavapipe stops rewriting sums of products, exact mode may retire.
    let (body, inputs, outputs, rust) = REWRITTEN[1];
    let job = Job { library: "", body, inputs, outputs, dictionary: &[] };
    assert!(differing(Gpu::lavapipe(), Mode::Shipped, job, rust) > 0);
}

/// The same expressions, and where they need `kept`. Not the division: SwiftShader multiplies by
/// the reciprocal of every literal.
const PROTECTED: [Rewritten; 6] = [
    (
        "let a = at(0); let b = at(1); let s = kept(a + b); let t = s - a;
         put(0, s); put(1, (a - (s - t)) + (b - t));",
        2,
        2,
        two_sum,
    ),
    ("put(0, kept(at(0) * at(1)) + at(0) * at(2));", 3, 1, REWRITTEN[1].3),
    ("put(0, kept(at(0) + 0.1) + 0.2);", 1, 1, REWRITTEN[2].3),
    ("put(0, 3.0 * kept(at(0) * 0.7));", 1, 1, REWRITTEN[3].3),
    ("let r = kept(sqrt(abs(at(0)))); put(0, r * r);", 1, 1, REWRITTEN[5].3),
    ("let s = kept(at(0) + at(1)); put(0, at(1) - (s - at(0)));", 2, 1, |x| {
        vec![x[1] - ((x[0] + x[1]) - x[0])]
    }),
];

#[test]
fn kept_protects_shipped_code() {
    for gpu in Gpu::every() {
        for (body, inputs, outputs, rust) in PROTECTED.into_iter().filter(|it| rounds(gpu, it.0)) {
            let job = Job { library: &kept(), body, inputs, outputs, dictionary: &[] };
            let [shipped, exact] =
                [Mode::Shipped, Mode::Exact].map(|mode| differing(gpu, mode, job, rust));
            assert_eq!(exact, 0, "{}: {body}", gpu.name());
            // Real GPUs fuse a product into a sum, which `kept` around the other one allows.
            let fused = gpu.kind() == Driver::Hardware && body.contains('*');
            assert!(shipped == 0 || fused, "{}: {shipped} differ: {body}", gpu.name());
        }
    }
}

#[test]
fn derivatives_are_differences_within_quads() {
    const SIZE: usize = 8;
    let fragment = "
@fragment fn fragment(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
    let f = height(at.xy);
    return vec4<f32>(f, dpdxFine(f), dpdyFine(f), dpdx(f));
}";
    let library = "
@group(0) @binding(0) var<storage, read> weights: array<f32>;
fn height(p: vec2<f32>) -> f32 {
    return weights[0] * p.x * p.x + weights[1] * p.x * p.y + weights[2] * p.y * p.y;
}";
    for gpu in Gpu::every() {
        let size = SIZE as u32;
        let weights: [&[f32]; 1] = [&[1.0, 3.0, 10.0]];
        let picture = Painter::new(gpu, library, fragment, &weights, size, size).unwrap().draw();
        let f = |x: usize, y: usize| {
            let [x, y] = [x as f32 + 0.5, y as f32 + 0.5];
            x * x + 3.0 * x * y + 10.0 * y * y
        };
        for (k, pixel) in picture.iter().enumerate() {
            let (x, y) = (k % SIZE, k / SIZE);
            let (left, top) = (x & !1, y & !1);
            let across = |row| f(left + 1, row) - f(left, row);
            let fine = [f(x, y), across(y), f(x, top + 1) - f(x, top)];
            assert_eq!(pixel[..3], fine, "{} {x} {y}", gpu.name());
            // A driver may take either row of the quad.
            assert!([across(top), across(top + 1)].contains(&pixel[3]), "{} {x} {y}", gpu.name());
        }
    }
}

#[test]
fn wrong_text_is_pointed_at() {
    let gpu = Gpu::lavapipe();
    for mode in [Mode::Shipped, Mode::Exact] {
        let job = Job {
            library: "",
            body: "put(0, at(0) + flase);",
            inputs: 1,
            outputs: 1,
            dictionary: &[],
        };
        let message = job.run(gpu, mode, &[1.0]).unwrap_err();
        assert!(message.contains("flase") && message.contains("^^^^^"), "{message}");
        let job = Job { library: "fn f() -> f32 { return 1u; }", body: "", ..job };
        let message = job.run(gpu, mode, &[1.0]).unwrap_err();
        assert!(message.contains("return 1u"), "{message}");
    }
    let message = Painter::new(gpu, "", "fn fragment() -> i32 { return; }", &[], 1, 1).unwrap_err();
    assert!(message.contains("fragment"), "{message}");
    let message = Painter::new(gpu, "", "fn other() {}", &[], 1, 1).unwrap_err();
    assert!(message.contains("no fragment entry point named `fragment`"), "{message}");
}

#[test]
fn decorated_code_is_valid() {
    let library = "
fn all(x: f32, y: vec3<f32>, m: mat3x3<f32>) -> f32 {
    let v = select(m * y, -y * m, y < vec3<f32>(x)) * x;
    return dot(v, sqrt(abs(y))) % 3.0 + fma(x, x, exp2(x)) + length(transpose(m)[1] / v);
}";
    let body = "put(0, all(at(0), vec3<f32>(at(0)), mat3x3<f32>()));";
    let job = Job { library, body, inputs: 1, outputs: 1, dictionary: &[] };
    let plain = spirv::assembled(&job.wgsl()).unwrap();
    let mut decorated = plain.clone();
    exact::no_contraction(&mut decorated);
    assert!(decorated.len() > plain.len());
    match tools::spirv_val(&decorated) {
        Some(verdict) => assert_eq!(verdict, Ok(String::new())),
        None => println!("skipped: spirv-val is not installed"),
    }
}

#[test]
fn work_takes_time() {
    let body = "var y = at(0); for (var k = 0; k < 64; k++) { y = y * y - 0.5; } put(0, y);";
    let inputs = vec![0.25; 1 << 16];
    for gpu in Gpu::every() {
        let job = Job { library: "", body, inputs: 1, outputs: 1, dictionary: &[] };
        let kernel = job.compile(gpu, Mode::Shipped).unwrap();
        let loaded = kernel.load(&inputs);
        loaded.dispatch();
        let stamped = loaded.nanoseconds(3);
        assert_eq!(stamped.is_some(), gpu.has_timestamps());
        assert!(stamped.iter().flatten().all(|&time| time > 0.0), "{stamped:?}");
        let seconds = timing::least_cpu_seconds(3, &mut [&mut || loaded.dispatch()]);
        assert!(seconds[0] > 0.0, "{seconds:?}");
    }
}
