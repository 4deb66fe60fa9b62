//! Pictures of errors, as small PNGs that a page magnifies.

use std::io::Cursor;

use anyhow::Context;
use base64::{Engine, prelude::BASE64_STANDARD};
use image::{ImageFormat, Rgb, RgbImage, imageops::crop_imm};
use zrow_methods::{SIZE, Shape};

use super::errors::FULL;

/// A row of panels.
pub struct Picture {
    panels: Vec<Panel>,
    /// What is to be seen.
    pub caption: String,
}

enum Panel {
    Pixels(RgbImage),
    /// The markup of a drawing.
    Drawing(String),
}

const PAPER: Rgb<u8> = Rgb([255, 255, 255]);
const INK: Rgb<u8> = Rgb([60, 60, 60]);
const MISSING: Rgb<u8> = Rgb([30, 100, 230]);
const TOO_MUCH: Rgb<u8> = Rgb([220, 40, 30]);
/// Errors are not magnified more than that.
const MOST_GAIN: f64 = 64.0;

impl Picture {
    /// The shape, its coverage, and the error magnified.
    pub fn of_coverage(shape: &Shape, exact: &[f64], mask: &[u8]) -> Self {
        Self::of_coverage_in(SIZE, shape, exact, mask)
    }

    /// The same in a square of so many pixels.
    pub fn of_coverage_in(size: usize, shape: &Shape, exact: &[f64], mask: &[u8]) -> Self {
        let errors: Vec<f64> = exact
            .iter()
            .zip(mask)
            .map(|(coverage, covered)| f64::from(*covered) - coverage * FULL)
            .collect();
        let largest = errors.iter().fold(0.0f64, |largest, error| largest.max(error.abs()));
        let gain = gain(largest);
        let at = |x: u32, y: u32| y as usize * size + x as usize;
        let pixels = size as u32;
        let covered = RgbImage::from_fn(pixels, pixels, |x, y| {
            let grey = 255 - mask[at(x, y)];
            Rgb([grey; 3])
        });
        let error = RgbImage::from_fn(pixels, pixels, |x, y| tint(errors[at(x, y)] * gain));
        Self {
            panels: vec![
                Panel::Drawing(outline(shape, size)),
                Panel::Pixels(covered),
                Panel::Pixels(error),
            ],
            caption: format!("shape, coverage, error x {gain} (red over, blue under), at most {largest:.1}/255"),
        }
    }

    /// Errors up to 255 of the pixels of a square.
    pub fn of_errors(errors: &[f64], size: usize, caption: String) -> Self {
        let image = RgbImage::from_fn(size as u32, size as u32, |x, y| {
            tint(errors[y as usize * size + x as usize])
        });
        Self {
            panels: vec![Panel::Pixels(image)],
            caption,
        }
    }

    /// Pixels that are drawn, and those that should be.
    pub fn of_pixels(drawn: &[(i32, i32)], right: &[(i32, i32)], (width, height): (u32, u32), caption: String) -> Self {
        let mut image = RgbImage::from_pixel(width, height, PAPER);
        let mut put = |&(x, y): &(i32, i32), color| {
            let position = u32::try_from(x).ok().zip(u32::try_from(y).ok());
            if let Some(pixel) = position.and_then(|(x, y)| image.get_pixel_mut_checked(x, y)) {
                *pixel = color;
            }
        };
        right.iter().for_each(|pixel| put(pixel, MISSING));
        for pixel in drawn {
            put(pixel, if right.contains(pixel) { INK } else { TOO_MUCH });
        }
        Self {
            panels: vec![Panel::Pixels(image)],
            caption,
        }
    }

    /// The 48 x 48 pixels about the first one that differs.
    pub fn of_difference(drawn: &[(i32, i32)], right: &[(i32, i32)], caption: String) -> Self {
        let wrong = drawn.iter().find(|pixel| !right.contains(pixel));
        let (x, y) = wrong.or(right.first()).copied().unwrap_or_default();
        let moved = |pixels: &[(i32, i32)]| -> Vec<(i32, i32)> {
            pixels
                .iter()
                .map(|pixel| (pixel.0 - x + 24, pixel.1 - y + 24))
                .collect()
        };
        Self::of_pixels(&moved(drawn), &moved(right), (48, 48), caption)
    }

    /// A drawing; `markup` is the content of an SVG element with that view box.
    pub fn of_drawing(view_box: &str, markup: &str, caption: String) -> Self {
        Self {
            panels: vec![Panel::Drawing(drawing(view_box, markup))],
            caption,
        }
    }

    /// The first image of pixels.
    fn image(&self) -> Option<&RgbImage> {
        self.panels.iter().find_map(|panel| match panel {
            Panel::Pixels(image) => Some(image),
            Panel::Drawing(_) => None,
        })
    }

    /// The columns and the rows in which the first image shows something: left, top, right, bottom, the last ones excluded.
    pub fn covered(&self) -> Option<[u32; 4]> {
        let shown = self
            .image()?
            .enumerate_pixels()
            .filter(|(_, _, pixel)| **pixel != PAPER);
        shown.map(|(x, y, _)| [x, y, x + 1, y + 1]).reduce(around)
    }

    /// A part of the first image, as wide as so many pixels of the page.
    ///
    /// # Errors
    /// It cannot be encoded.
    pub fn magnified(&self, [left, top, right, bottom]: [u32; 4], width: u32) -> anyhow::Result<String> {
        let Some(image) = self.image() else {
            return Ok(String::new());
        };
        let part = crop_imm(image, left, top, right - left, bottom - top);
        element(&part.to_image(), width)
    }

    /// The panels as elements of a page.
    pub fn html(&self) -> anyhow::Result<String> {
        let panels = self.panels.iter().map(|panel| match panel {
            Panel::Drawing(markup) => Ok(markup.clone()),
            Panel::Pixels(image) => {
                let (width, height) = image.dimensions();
                element(image, width * (144 / width.max(height)).max(1))
            }
        });
        panels.collect::<anyhow::Result<Vec<_>>>().map(|panels| panels.concat())
    }
}

/// The columns and the rows around two boxes.
pub fn around([left, top, right, bottom]: [u32; 4], other: [u32; 4]) -> [u32; 4] {
    [
        left.min(other[0]),
        top.min(other[1]),
        right.max(other[2]),
        bottom.max(other[3]),
    ]
}

/// An image as an element of a page, so wide.
fn element(image: &RgbImage, width: u32) -> anyhow::Result<String> {
    let bytes = BASE64_STANDARD.encode(png(image)?);
    let height = image.height() * width / image.width();
    Ok(format!(
        "<img class=\"pixels\" width=\"{width}\" height=\"{height}\" alt=\"\" src=\"data:image/png;base64,{bytes}\">"
    ))
}

/// A power of two by which errors up to that one can be multiplied.
fn gain(largest: f64) -> f64 {
    let mut gain = 1.0;
    while gain < MOST_GAIN && largest * gain * 2.0 <= FULL {
        gain *= 2.0;
    }
    gain
}

/// White for none, red for too much, blue for too little.
fn tint(error: f64) -> Rgb<u8> {
    let full = if error > 0.0 { TOO_MUCH } else { MISSING };
    let part = (error.abs() / FULL).min(1.0);
    Rgb(full
        .0
        .map(|channel| (FULL - (FULL - f64::from(channel)) * part).round() as u8))
}

fn outline(shape: &Shape, size: usize) -> String {
    let mut path = String::new();
    for contour in &shape.contours {
        for (index, (x, y)) in contour.iter().enumerate() {
            // From pixel centres to corners.
            let position = |units: i32| f64::from(units) / f64::from(shape.units) + 0.5;
            path += &format!(
                "{}{:.2} {:.2}",
                if index == 0 { "M" } else { "L" },
                position(*x),
                position(*y)
            );
        }
        path.push('Z');
    }
    let rule = match shape.rule {
        zrow_methods::Rule::EvenOdd => "evenodd",
        zrow_methods::Rule::NonZero => "nonzero",
    };
    drawing(
        &format!("0 0 {size} {size}"),
        &format!("<path fill-rule=\"{rule}\" d=\"{path}\"/>"),
    )
}

fn drawing(view_box: &str, markup: &str) -> String {
    format!("<svg class=\"pixels\" viewBox=\"{view_box}\" width=\"144\" height=\"144\">{markup}</svg>")
}

/// A picture as a PNG file.
pub fn png(image: &RgbImage) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Cursor::new(Vec::new());
    image
        .write_to(&mut bytes, ImageFormat::Png)
        .context("cannot encode a PNG")?;
    Ok(bytes.into_inner())
}
