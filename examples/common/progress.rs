//! How far the work is, on a terminal; and Ctrl-C, which ends it in order.

use indicatif::{ProgressBar, ProgressStyle};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// A bar on standard error where that is a terminal, nothing elsewhere.
pub(crate) struct Progress {
    bar: ProgressBar,
    stopped: Arc<AtomicBool>,
}

impl Progress {
    /// A bar of no length yet, and a handler of Ctrl-C.
    pub(crate) fn new() -> Self {
        let stopped = Arc::new(AtomicBool::new(false));
        let stop = Arc::clone(&stopped);
        // Without a handler Ctrl-C works as ever, and leaves the temporary folder.
        let _ = ctrlc::set_handler(move || stop.store(true, Ordering::Relaxed));
        let bar = ProgressBar::new(0);
        if let Ok(style) = ProgressStyle::with_template("{msg:16} {wide_bar} {percent:>3} %") {
            bar.set_style(style);
        }
        Self { bar, stopped }
    }

    /// How many steps there are in all.
    pub(crate) fn begin(&self, steps: u64) {
        self.bar.set_length(steps);
    }

    /// What is done now.
    pub(crate) fn stage(&self, name: &'static str) {
        self.bar.set_message(name);
    }

    /// So many steps more; fails if the work shall end.
    pub(crate) fn by(&self, steps: u64) -> Result<(), String> {
        self.bar.inc(steps);
        if self.stopped() { Err("stopped; nothing was written".to_owned()) } else { Ok(()) }
    }

    /// Whether Ctrl-C was pressed.
    pub(crate) fn stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed)
    }

    /// The bar disappears.
    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}
