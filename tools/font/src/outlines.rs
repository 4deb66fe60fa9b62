//! A font of outlines: what a module holds, before it is written.

use anyhow::{Context, ensure};
use skrifa::{
    MetadataProvider,
    instance::{LocationRef, Size},
    outline::DrawSettings,
};

use crate::{
    font::{Names, Pair, Source},
    quadratics::{Point, QuadraticPen},
};

/// What a font is converted to.
#[derive(Debug, Clone)]
pub struct OutlineOptions {
    /// Units of the em square; `None` for those that the font has.
    pub units: Option<u16>,
    /// The characters, sorted.
    pub characters: Vec<char>,
    /// Whether kerning is read.
    pub kerning: bool,
    /// What is drawn for characters that the font does not have; one of `characters`.
    pub replacement: Option<char>,
}

/// Units of an em square.
const UNITS: std::ops::RangeInclusive<u16> = 16..=16_384;

/// A glyph.
#[derive(Debug, Clone)]
pub struct OutlineGlyph {
    /// What the glyph is for.
    pub character: char,
    /// The contours, each beginning with a point on it.
    pub contours: Vec<Vec<Point>>,
    /// How far the pen moves on.
    pub advance: u16,
}

impl OutlineGlyph {
    /// All points, contour by contour.
    pub fn points(&self) -> impl Iterator<Item = &Point> {
        self.contours.iter().flatten()
    }

    /// The smallest x and y and the largest x and y of all points; all 0 without points.
    pub fn bounds(&self) -> [i16; 4] {
        let x = || self.points().map(|point| point.x);
        let y = || self.points().map(|point| point.y);
        [x().min(), y().min(), x().max(), y().max()].map(Option::unwrap_or_default)
    }
}

/// A converted font; lengths are in its units, of which [`units`](Self::units) are an em.
#[derive(Debug, Clone)]
pub struct Outlines {
    /// The names that the font gives itself.
    pub names: Names,
    /// Units of the em square.
    pub units: u16,
    /// The glyphs, in the order of their characters.
    pub glyphs: Vec<OutlineGlyph>,
    /// Pairs of glyphs that are kerned, sorted.
    pub kerning: Vec<Pair>,
    /// How far lines reach above the baseline.
    pub ascent: u16,
    /// How far they reach below it.
    pub descent: u16,
    /// From line to line.
    pub line_height: u16,
    /// From the baseline down to the underline, and its thickness.
    pub underline: (i16, u16),
    /// From the baseline down to the strikethrough, and its thickness.
    pub strikethrough: (i16, u16),
}

/// The nearest number of 16 bits with sign.
fn nearest(units: f64) -> i16 {
    units.round() as i16
}

/// The nearest number of 16 bits without sign.
fn nearest_length(units: f64) -> u16 {
    units.round() as u16
}

impl Source<'_> {
    /// Converts the chosen characters to outlines.
    ///
    /// # Errors
    /// Each says what to do: characters without a glyph, glyphs that are too large or cannot be read, units out of range.
    pub fn convert_outlines(&self, options: &OutlineOptions) -> anyhow::Result<Outlines> {
        // At most 16,384, as a source is checked for.
        let units = options.units.unwrap_or(self.units_per_em as u16);
        ensure!(
            UNITS.contains(&units),
            "--units is {units}: choose {} to {}",
            UNITS.start(),
            UNITS.end()
        );
        ensure!(
            !options.characters.is_empty(),
            "there are no characters: name some with --chars"
        );
        let scale = f64::from(units) / self.units_per_em;
        let ids = self.glyph_ids(&options.characters)?;
        let metrics = self.font.glyph_metrics(Size::unscaled(), LocationRef::default());
        let mut glyphs = Vec::new();
        for (&character, &id) in options.characters.iter().zip(&ids) {
            let contours = || {
                let outline = self.outlines.get(id).context("its outline is missing")?;
                let mut pen = QuadraticPen::new(scale);
                let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
                outline.draw(settings, &mut pen).context("its outline cannot be read")?;
                let contours = pen.contours()?;
                let points: usize = contours.iter().map(Vec::len).sum();
                ensure!(
                    points <= usize::from(u16::MAX),
                    "it has {points} points, and a font takes {}: leave it out",
                    u16::MAX
                );
                Ok(contours)
            };
            glyphs.push(OutlineGlyph {
                character,
                contours: contours().with_context(|| format!("the glyph of {character:?} cannot be converted"))?,
                advance: nearest_length(f64::from(metrics.advance_width(id).unwrap_or_default()) * scale),
            });
        }
        let kerning = if options.kerning {
            self.pairs(&ids, |adjustment| (f64::from(adjustment) * scale).round())?
        } else {
            Vec::new()
        };
        Ok(self.with_line_metrics(units, glyphs, kerning))
    }

    fn with_line_metrics(&self, units: u16, glyphs: Vec<OutlineGlyph>, kerning: Vec<Pair>) -> Outlines {
        let scale = f64::from(units) / self.units_per_em;
        let metrics = self.font.metrics(Size::unscaled(), LocationRef::default());
        let scaled = |length: f32| f64::from(length) * scale;
        let top = glyphs.iter().map(|glyph| glyph.bounds()[3]).max().unwrap_or(0);
        let bottom = glyphs.iter().map(|glyph| glyph.bounds()[1]).min().unwrap_or(0);
        let decoration = |decoration: Option<skrifa::metrics::Decoration>, otherwise: f64| {
            let below = decoration.map_or(otherwise, |decoration| -scaled(decoration.offset));
            let thickness = decoration.map_or(f64::from(units) / 16.0, |decoration| scaled(decoration.thickness));
            (nearest(below), nearest_length(thickness).max(1))
        };
        Outlines {
            names: Names::of(&self.font),
            units,
            glyphs,
            kerning,
            ascent: nearest_length(scaled(metrics.ascent)).max(top.max(0).unsigned_abs()),
            descent: nearest_length(scaled(-metrics.descent)).max(bottom.min(0).unsigned_abs()),
            line_height: nearest_length(scaled(metrics.ascent - metrics.descent + metrics.leading)).max(1),
            underline: decoration(metrics.underline, f64::from(units) / 8.0),
            strikethrough: decoration(metrics.strikeout, -f64::from(units) / 4.0),
        }
    }
}
