//! The shaders' sizes on the page, and what filtering adds to them.

use super::table::{Line, Table};
use crate::sizes::Sizes;

const NOTE: &str = "SPIR-V by naga, before any driver has optimized it: one instruction for every \
    operation, load, \
                    field and branch; with every call written out and loops counted once. \
                    Of these, arithmetic, comparisons, selects and extended instructions compute; \
                    the rest moves numbers, and a driver's compiler leaves little of it. \
                    Kaplanyan et al. 2016, Table 3, \
                    counts what NVIDIA's compiler made of GLSL, so compare orders within a \
                    column, not across.";

fn presets(sizes: &Sizes) -> Table {
    let rows = sizes.presets.iter().map(|size| Line {
        cells: vec![
            size.name.clone(),
            size.bytes.to_string(),
            size.functions.to_string(),
            size.instructions.to_string(),
            size.inlined.to_string(),
            size.arithmetic.to_string(),
        ],
        class: "",
    });
    let headers = &["Shader", "Bytes", "Functions", "SPIR-V", "Calls written out", "Computing"];
    Table { headers, rows: rows.collect() }
}

fn overheads(sizes: &Sizes) -> Table {
    let rows = sizes.overheads.iter().map(|overhead| Line {
        cells: vec![
            overhead.name.to_owned(),
            overhead.instructions.to_string(),
            overhead.arithmetic.to_string(),
            overhead.kaplanyan.map_or_else(|| "\u{2013}".to_owned(), |count| count.to_string()),
        ],
        class: "",
    });
    Table {
        headers: &["Filtering adds", "SPIR-V", "Computing", "Kaplanyan's nearest, Table 3"],
        rows: rows.collect(),
    }
}

/// As text.
pub(super) fn text(sizes: &Sizes) -> String {
    format!(
        "\nShaders by `lobe::wgsl`, what each scene needs and no more\n{}\n{}{NOTE}\n",
        presets(sizes).text(),
        overheads(sizes).text(),
    )
}

/// As a section.
pub(super) fn html(sizes: &Sizes) -> String {
    format!(
        "<section>\n<h2>Shaders</h2>\n<p>What each scene needs, and no more: the text that \
            <code>lobe::wgsl</code> gives \
         for it.</p>\n{}\n<p>What filtering adds.</p>\n{}<p class=\"note\">{}</p>\n</section>\n",
        presets(sizes).html(),
        overheads(sizes).html(),
        super::escape(NOTE),
    )
}
