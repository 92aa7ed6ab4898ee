//! What filtering costs a shader: CPU time on lavapipe, and the GPU's own clock at 3840 x 2160.
//!
//! `cargo run --release -p lobe-gpu --example cost`, `-- --help` for the rest.

mod method;
#[path = "../../../../examples/common/say.rs"]
mod say;

use std::process::{Command, ExitCode};

use clap::Parser;
use lobe::wgsl::{Item, source};
use lobe_gpu::{Gpu, Job, Kernel, Mode, Painter, needed, timing};
use lobe_report::shot::Shot;
use lobe_report::spirv::{assembled, instructions};
use method::{FLOATS, METHODS, Method};
use say::say;

/// Costs of filtered shading against unfiltered, of every method of the WGSL port.
#[derive(Parser)]
struct Options {
    /// Roughness of the surface.
    #[arg(long, default_value_t = 0.01)]
    alpha: f64,
    /// Width of the picture that GPUs draw; the height is 9/16 of it.
    #[arg(long, default_value_t = 3840, value_parser = clap::value_parser!(u32).range(16..=8192))]
    width: u32,
    /// Frames of each method on each GPU; the median counts.
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    frames: u32,
    /// Only count instructions and CPU time.
    #[arg(long)]
    no_frames: bool,
    /// What the program calls itself with, for the CPU's part.
    #[arg(long, hide = true)]
    one_thread: bool,
    /// Only count the instructions of every function.
    #[arg(long)]
    functions: bool,
}

/// The variable by which lavapipe works on the calling thread.
const THREADS: &str = "LP_NUM_THREADS";

fn main() -> ExitCode {
    let options = Options::parse();
    if !(options.alpha > 0.0 && options.alpha <= 1.0) {
        say(&format!("error: --alpha {0}: alpha = {0} is not in (0, 1]", options.alpha));
        return ExitCode::from(2);
    }
    if options.functions {
        return concluded(functions());
    }
    // CPU time by the process means something only where the driver has no threads of its own.
    let result = if options.one_thread {
        cpu(&options)
    } else {
        again().and_then(|()| if options.no_frames { Ok(()) } else { frames(&options) })
    };
    concluded(result)
}

/// An error is one line, and exit code 2.
fn concluded(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            say(&format!("error: {message}"));
            ExitCode::from(2)
        }
    }
}

/// The table of functions: SPIR-V instructions of their own, and with every call written out.
fn functions() -> Result<(), String> {
    println!("{:48} {:>6} {:>14}", "Function", "SPIR-V", "SPIR-V, inline");
    for function in instructions(&assembled(&source(Item::ALL))?) {
        println!("{:48} {:6} {:14}", function.name, function.own, function.inlined);
    }
    Ok(())
}

/// This program once more, on one thread, for the CPU's part.
fn again() -> Result<(), String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let status = Command::new(program)
        .args(std::env::args_os().skip(1))
        .arg("--one-thread")
        .env(THREADS, "0")
        .status()
        .map_err(|error| error.to_string())?;
    if status.success() {
        Ok(())
    } else {
        Err(String::from("the measurement on one thread failed"))
    }
}

/// What a compute shader reads, from the report's plane of leather: of each pixel, and of its quad.
fn samples(alpha: f64) -> Result<Vec<f32>, String> {
    let shot = Shot::leather(lobe_report::QUICK_WIDTH, alpha)?;
    let [columns, rows] = shot.quad_size();
    let mut floats = Vec::with_capacity(columns * rows * FLOATS);
    for k in 0..columns * rows {
        let [here, right, up] = shot.quad(k % columns, k / columns);
        floats.extend([here.wo, here.wi, here.half, right.half, up.half].concat());
        // A normal's change: half of the half vector's, as under a fixed lamp and eye.
        for other in [right, up] {
            floats.extend([0, 1, 2].map(|axis| 0.5 * (other.half[axis] - here.half[axis])));
        }
    }
    Ok(floats)
}

/// SPIR-V instructions of the shader, every call written out.
fn weight(job: &Job<'_>) -> Result<usize, String> {
    let functions = instructions(&assembled(&job.wgsl())?);
    let whole = functions.iter().find(|function| function.name == "job");
    Ok(whole.map_or(0, |function| function.inlined))
}

/// The table of CPU times, on one thread, works taking turns.
fn cpu(options: &Options) -> Result<(), String> {
    const ROUNDS: usize = 15;
    const REPEATS: usize = 24;
    let gpu = Gpu::lavapipe();
    // Many more than there are pixels: a dispatch costs as much as thousands of samples.
    let floats = samples(options.alpha)?.repeat(REPEATS);
    let bodies: Vec<String> = METHODS.iter().map(|method| method.compute(options.alpha)).collect();
    let copy = "put(0u, at(0u));";
    let libraries: Vec<String> = bodies.iter().map(|body| needed(body)).collect();
    let job = |library, body| Job { library, body, inputs: FLOATS, outputs: 1, dictionary: &[] };
    let jobs: Vec<Job<'_>> = libraries.iter().zip(&bodies).map(|(l, b)| job(l, b)).collect();
    let compile = |job: &Job<'_>| job.compile(gpu, Mode::Shipped);
    let kernels: Vec<Kernel> =
        [job("", copy)].iter().chain(&jobs).map(compile).collect::<Result<_, _>>()?;
    let loaded: Vec<_> = kernels.iter().map(|kernel| kernel.load(&floats)).collect();
    let mut works: Vec<_> = loaded.iter().map(|loaded| move || loaded.dispatch()).collect();
    let mut works: Vec<&mut dyn FnMut()> =
        works.iter_mut().map(|work| work as &mut dyn FnMut()).collect();
    let times = timing::least_cpu_seconds(ROUNDS, &mut works);
    let empty = times[0];
    println!(
        "CPU time of {} on one thread of {}, {} samples from the report's leather plane, alpha \
            {}:\n\
         net of a shader that only copies a number, least of {ROUNDS} rounds in which all take \
         turns.\n",
        gpu.name(),
        lobe_report::processor(),
        floats.len() / FLOATS,
        options.alpha,
    );
    println!("{:34} {:>10} {:>14} {:>8}", "Method", "time over", "SPIR-V, inline", "more");
    let weights: Vec<usize> = jobs.iter().map(weight).collect::<Result<_, _>>()?;
    // A method without a filter is its own base, and comes before those that it is the base of.
    let mut base = 0;
    for (k, method) in METHODS.iter().enumerate() {
        let own = weights[k];
        if method.name == method.base {
            base = k;
        }
        let ratio = (times[k + 1] - empty) / (times[base + 1] - empty);
        let more = own.checked_sub(weights[base]).filter(|_| base != k);
        let more = more.map_or(String::new(), |more| format!("+{more}"));
        println!("{:34} {ratio:10.2} {own:14} {more:>8}", method.name);
    }
    println!("\nTime over: over the same distribution, isotropic, without a filter.\n");
    Ok(())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// The table of frame times, on every driver with a clock.
fn frames(options: &Options) -> Result<(), String> {
    let (width, height) = (options.width, (options.width * 9 / 16).next_multiple_of(2));
    for gpu in Gpu::every().iter().filter(|gpu| gpu.has_timestamps()) {
        println!(
            "{}, {width} x {height}, 1 sample per pixel, alpha {}: milliseconds of a frame by \
                timestamps, median of {}",
            gpu.name(),
            options.alpha,
            options.frames,
        );
        println!("{:34} {:>9} {:>9} {:>22}", "Method", "frame", "filter", "his nearest, Table 2");
        let mut base = f64::NAN;
        for method in &METHODS {
            let time = frame(gpu, method, options, [width, height])?;
            let filter = if method.name == method.base {
                base = time;
                String::new()
            } else {
                format!("{:+.3}", time - base)
            };
            let his = method.kaplanyan.map_or(String::new(), |ms| format!("{ms:+.2}"));
            println!("{:34} {time:9.3} {filter:>9} {his:>22}", method.name);
        }
        println!();
    }
    println!(
        "Kaplanyan et al. 2016, Table 2: what the nearest of his methods added in Sponza with \
            normal maps, 3840 x 2160, Quadro M6000."
    );
    Ok(())
}

/// Milliseconds of one method's frame.
fn frame(
    gpu: &'static Gpu,
    method: &Method,
    options: &Options,
    [width, height]: [u32; 2],
) -> Result<f64, String> {
    let text = method.fragment(options.alpha);
    let painter = Painter::new(gpu, &needed(&text), &text, &[], width, height)?;
    // The first frame compiles.
    painter.paint();
    let times = painter.nanoseconds(options.frames as usize);
    Ok(median(times.ok_or("no timestamps")?) * 1e-6)
}
