//! PNG files as tools write them, and as disks and networks damage them.

use super::picture::{SIZE, assembled, checksum, filtered, interlaced, picture, rgb, texels, zlib};
use super::{bake, baked, complains, expected, folder, holds, names, warned};
use lobe::material::lean::Border;
use png::{BitDepth, ColorType};
use std::fs;

/// Chunks of a PNG, in order.
type Chunks<'a> = &'a [(&'a [u8; 4], Vec<u8>)];

/// The map of the other tests from these chunks.
fn whole(chunks: Chunks) -> Vec<u8> {
    assembled(SIZE, ColorType::Rgb, BitDepth::Eight, false, chunks)
}

/// The pixels of that map as they are compressed.
fn pixels() -> Vec<u8> {
    zlib(&filtered(texels().as_flattened(), SIZE[1]))
}

/// The same with a wrong sum at their end.
fn damaged() -> Vec<u8> {
    let mut pixels = pixels();
    *pixels.last_mut().expect("a sum") ^= 1;
    pixels
}

/// Cut into two chunks before the last `count` bytes.
fn cut(pixels: &[u8], count: usize) -> [(&'static [u8; 4], Vec<u8>); 2] {
    let (head, tail) = pixels.split_at(pixels.len() - count);
    [(b"IDAT", head.to_vec()), (b"IDAT", tail.to_vec())]
}

/// An animation's next frame: its place in the sequence, its size, its pixels.
fn frame(first: u32, pixels: &[u8]) -> [(&'static [u8; 4], Vec<u8>); 2] {
    let numbers = [first, SIZE[0], SIZE[1], 0, 0].map(u32::to_be_bytes);
    let control = [numbers.as_flattened(), &[0, 1, 0, 10, 0, 0]].concat();
    let data = [&(first + 1).to_be_bytes()[..], pixels].concat();
    [(b"fcTL", control), (b"fdAT", data)]
}

fn animation() -> (&'static [u8; 4], Vec<u8>) {
    (b"acTL", [1_u32, 0].map(u32::to_be_bytes).as_flattened().to_vec())
}

#[test]
fn files_of_other_tools_are_the_same_map() {
    let folder = folder("tools");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let map = expected(&texels(), 10.0, Border::Wrap);
    let data = (b"IDAT", pixels());
    let each: Vec<_> = pixels().iter().map(|&byte| (b"IDAT", vec![byte])).collect();
    let none = (b"IDAT", Vec::new());
    let gamma = (b"gAMA", 45_455_u32.to_be_bytes().to_vec());
    let profile = (b"iCCP", b"no profile\0\0at all".to_vec());
    let opaque: Vec<u8> = texels().iter().flat_map(|&[x, y, z]| [x, y, z, 255]).collect();
    let [control, further] = frame(0, &pixels());
    let key = [1, 2, 3].map(u16::to_be_bytes).as_flattened().to_vec();
    let files = [
        whole(std::slice::from_ref(&data)),
        // Pixels byte by byte, with empty chunks, with their sum in a chunk of its own.
        whole(&each),
        whole(&[none.clone(), data.clone(), none]),
        whole(&cut(&pixels(), 4)),
        whole(&cut(&pixels(), 2)),
        // Color spaces and notes, which are not about normals; a private chunk.
        whole(&[(b"sRGB", vec![0]), gamma, data.clone(), (b"tEXt", b"Software\0any".to_vec())]),
        whole(&[profile, (b"pHYs", vec![0; 9]), data.clone(), (b"eXIf", b"MM\0*".to_vec())]),
        whole(&[(b"prVt", vec![7; 99]), data.clone()]),
        // Animations: of one frame beside the still picture.
        whole(&[animation(), data.clone(), control, further]),
        // A transparent color that no texel has; alpha that is opaque.
        whole(&[(b"tRNS", key), data]),
        picture(SIZE, ColorType::Rgba, BitDepth::Eight, &opaque),
        interlaced(&texels()),
    ];
    for file in &files {
        fs::write(&input, file).expect("a file");
        let (_, warnings) = warned(&input, &out, &[]);
        // One texel of 15 is below the horizon.
        assert!(
            warnings.len() == 1 && warnings[0].starts_with("6.7 % of the texels"),
            "{warnings:?}"
        );
        holds(&out, &map);
    }
    // Bytes after the end are told of.
    fs::write(&input, [&files[0][..], b"PK\x03\x04"].concat()).expect("a file");
    let (_, warnings) = warned(&input, &out, &[]);
    assert_eq!(warnings[0], "4 bytes after the picture's end are ignored");
    holds(&out, &map);
}

#[test]
fn palettes_of_all_depths_are_expanded_exactly() {
    let folder = folder("palettes");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    // Not above 128, so that one bit has two colors that differ in all channels.
    let colors: Vec<[u8; 3]> = (0..16_u8).map(|k| [97 + 3 * k, 151 - 5 * k, 250 - 2 * k]).collect();
    for (depth, bits) in
        [(BitDepth::One, 1_usize), (BitDepth::Two, 2), (BitDepth::Four, 4), (BitDepth::Eight, 8)]
    {
        let count: u8 = if bits < 4 { 1 << bits } else { 16 };
        let indices: Vec<u8> = (0..15_u8).map(|k| k.wrapping_mul(7) % count).collect();
        let texels: Vec<[u8; 3]> = indices.iter().map(|&k| colors[usize::from(k)]).collect();
        // Rows of five texels, from the highest bits on, to whole bytes.
        let rows = indices.chunks_exact(5).flat_map(|row| {
            let packed = row.iter().fold(0_u64, |sum, &k| sum << bits | u64::from(k));
            let bytes = (5 * bits).div_ceil(8);
            (packed << (8 * bytes - 5 * bits)).to_be_bytes()[8 - bytes..].to_vec()
        });
        let rows: Vec<u8> = rows.collect();
        let pixels = zlib(&filtered(&rows, SIZE[1]));
        let palette = colors[..usize::from(count)].as_flattened().to_vec();
        let file = |chunks: Chunks| assembled(SIZE, ColorType::Indexed, depth, false, chunks);
        let (colors, data) = ((b"PLTE", palette.clone()), (b"IDAT", pixels));
        fs::write(&input, file(&[colors.clone(), data.clone()])).expect("a file");
        baked(&input, &out, &[]);
        holds(&out, &expected(&texels, 10.0, Border::Wrap));

        // x in alpha: the colors' transparencies, 255 where a color has none.
        let alphas: Vec<u8> = (0..count).map(|k| 90 + 4 * k).collect();
        let transparency = (b"tRNS", alphas[..usize::from(count) - 1].to_vec());
        fs::write(&input, file(&[colors.clone(), transparency, data.clone()])).expect("a file");
        baked(&input, &out, &["--channels", "agb"]);
        let alpha = |k: u8| if k + 1 < count { alphas[usize::from(k)] } else { 255 };
        let moved = texels.iter().zip(&indices).map(|(&[_, y, z], &k)| [alpha(k), y, z]);
        holds(&out, &expected(&moved.collect::<Vec<_>>(), 10.0, Border::Wrap));

        // An index without a color, more transparencies than colors, no palette, a part of a color.
        let short = (b"PLTE", palette[3..].to_vec());
        let many = (b"tRNS", vec![0; usize::from(count) + 1]);
        let part = (b"PLTE", palette[..palette.len() - 1].to_vec());
        for (chunks, said) in [
            (vec![short, data.clone()], "texels of color"),
            (vec![colors, many, data.clone()], "transparenc"),
            (vec![part, data.clone()], "palette"),
            (vec![data], "palette"),
        ] {
            fs::write(&input, file(&chunks)).expect("a file");
            complains(&bake(&input, &out, &[]), &["normal.png: not a readable PNG", said]);
        }
    }
}

#[test]
fn heights_have_any_depth() {
    let folder = folder("depths");
    let (input, out) = (folder.join("height.png"), folder.join("moments"));
    let options = ["--height", "0.5", "--texel", "0.25"];
    let codes: Vec<u8> = (0..15_u8).map(|k| k * k % 3).collect();
    // Of 2 bits 0, 1, 2 are 0, 85, 170 of 255; a gray picture in colors and in a palette is one,
    // too.
    let wide: Vec<u8> = codes.iter().map(|&k| 85 * k).collect();
    let packed: Vec<u8> = codes
        .chunks_exact(5)
        .flat_map(|row| {
            let bits = row.iter().fold(0_u16, |sum, &k| sum << 2 | u16::from(k));
            (bits << 6).to_be_bytes()
        })
        .collect();
    let grays = [0_u8, 85, 170].iter().flat_map(|&v| [v, v, v]).collect();
    let data = || (b"IDAT", zlib(&filtered(&packed, SIZE[1])));
    let colors: Vec<u8> = wide.iter().flat_map(|&v| [v, v, v]).collect();
    let files = [
        picture(SIZE, ColorType::Grayscale, BitDepth::Eight, &wide),
        assembled(SIZE, ColorType::Grayscale, BitDepth::Two, false, &[data()]),
        assembled(SIZE, ColorType::Indexed, BitDepth::Two, false, &[(b"PLTE", grays), data()]),
        picture(SIZE, ColorType::Rgb, BitDepth::Eight, &colors),
    ];
    let mut first = None;
    for file in files {
        fs::write(&input, file).expect("a file");
        baked(&input, &out, &options);
        let raw = fs::read(out.join("moments.0.f32")).expect("a file");
        assert_eq!(first.get_or_insert_with(|| raw.clone()), &raw);
    }
}

#[test]
fn damage_anywhere_is_refused() {
    let folder = folder("damage");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let data = (b"IDAT", pixels());
    let plain = whole(std::slice::from_ref(&data));
    // However few bytes are missing.
    for missing in 1..=plain.len() {
        fs::write(&input, &plain[..plain.len() - missing]).expect("a file");
        let said = if missing == plain.len() { "empty" } else { "not a readable PNG" };
        complains(&bake(&input, &out, &[]), &["normal.png: ", said]);
    }
    // Any byte of the file: of names, lengths, pixels and checksums.
    let full = whole(&[(b"gAMA", vec![0, 0, 177, 143]), data.clone(), (b"tEXt", b"a\0b".to_vec())]);
    for k in 0..full.len() {
        let mut file = full.clone();
        file[k] ^= 0x20;
        fs::write(&input, file).expect("a file");
        complains(&bake(&input, &out, &[]), &["normal.png: "]);
    }
    // Pixels under a chunk's right checksum: their own sum wrong, in a chunk of its own, cut,
    // absent.
    let sums = [
        whole(&[(b"IDAT", damaged())]),
        whole(&cut(&damaged(), 4)),
        whole(&cut(&damaged(), 1)),
        whole(&cut(&pixels(), 2)[..1]),
        whole(&cut(&pixels(), 4)[..1]),
        // An animation's further frame.
        whole(&[&[animation(), data.clone()][..], &frame(0, &damaged())].concat()),
        // Fewer rows than the header says; transparency that is none; a chunk that must be known.
        whole(&[(b"IDAT", zlib(&filtered(texels()[..10].as_flattened(), 2)))]),
        whole(&[(b"tRNS", vec![0; 3]), data.clone()]),
        whole(&[(b"NEED", vec![]), data.clone()]),
        whole(&[data.clone(), (b"tIME", vec![0; 7]), data]),
    ];
    for file in sums {
        fs::write(&input, file).expect("a file");
        complains(&bake(&input, &out, &[]), &["normal.png: not a readable PNG"]);
        assert_eq!(names(&folder), ["normal.png"]);
    }
    // No pixels at all, under a header's right checksum.
    for side in [16, 20] {
        let mut file = plain.clone();
        file[side..side + 4].fill(0);
        let sum = checksum(&file[12..29]);
        file[29..33].copy_from_slice(&sum.to_be_bytes());
        fs::write(&input, file).expect("a file");
        complains(&bake(&input, &out, &[]), &["normal.png: not a readable PNG"]);
    }
}

#[test]
fn other_formats_are_named_whatever_the_file_is_called() {
    let folder = folder("formats");
    let (input, out) = (folder.join("normal.png"), folder.join("moments"));
    let formats: [(&[u8], &str); 8] = [
        (b"\xff\xd8\xff\xe0\0\x10JFIF", "JPEG"),
        (b"DDS |\0\0\0", "DDS"),
        (b"PK\x03\x04\x14\0", "zip"),
        (b"8BPS\0\x01", "Photoshop"),
        (b"\x76\x2f\x31\x01", "OpenEXR"),
        (b"RIFF\0\0\0\0WEBP", "WebP"),
        (b"II*\0", "TIFF"),
        (b"\xabKTX 20\xbb", "KTX"),
    ];
    for (begin, name) in formats {
        fs::write(&input, [begin, &[0; 64]].concat()).expect("a file");
        complains(&bake(&input, &out, &[]), &["normal.png: not a readable PNG", name]);
    }
    // Line ends that a transfer as text has changed.
    let file = rgb(&texels());
    fs::write(&input, [&file[..4], b"\n\x1a\n", &file[8..]].concat()).expect("a file");
    complains(&bake(&input, &out, &[]), &["normal.png: not a readable PNG"]);
}
