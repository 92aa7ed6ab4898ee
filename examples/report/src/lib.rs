//! Error against run time: every filter of lobe against plain supersampling, on scenes with glints.
//!
//! `cargo run --release -p lobe-report -- --help`. The way of the data: a `scene` gives samples, a
//! `method` shades them, `reference` is what they should have given, `metric` and `timing` put
//! numbers on both, `study` collects a scene's, `sequence` those of a scene in motion, `page` shows
//! them. `kernels` judges filters of GGX without any scene, `minify` those of normal maps, with a
//! renderer of its own, `relief` LEADR's grids against rays, `glints` two models of details against
//! the details, `facets` filters of many lobes against many samples. [`shot`] gives two of the
//! scenes to other renderers, as plain numbers.

mod camera;
#[path = "../../common/channels.rs"]
mod channels;
mod coverage;
mod facets;
mod footprints;
mod frame;
mod frontier;
mod glints;
#[path = "../../common/integrity.rs"]
mod integrity;
mod kernels;
mod level;
mod light;
#[path = "../../common/looks.rs"]
mod looks;
mod method;
mod metric;
mod minify;
mod options;
mod output;
mod overlap;
mod page;
mod pattern;
#[path = "../../common/picture.rs"]
mod picture;
mod program;
mod reference;
mod relief;
mod render;
#[path = "../../common/say.rs"]
mod say;
mod scalar;
mod scene;
mod sequence;
pub mod shot;
mod sizes;
pub mod spirv;
mod standing;
mod study;
#[path = "../../common/survey.rs"]
mod survey;
mod texture;
mod timing;
mod vector;
mod window;

pub use metric::Errors;
pub use program::run;
pub use study::QUICK_WIDTH;
pub use timing::processor;
