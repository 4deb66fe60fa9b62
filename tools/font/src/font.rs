//! A font at one size: what a module holds, before it is written.

use anyhow::{Context, bail, ensure};
use skrifa::{
    FontRef, GlyphId, MetadataProvider,
    instance::{LocationRef, Size},
    outline::{DrawSettings, Engine, HintingInstance, HintingOptions, OutlineGlyphCollection, SmoothMode, Target},
    string::StringId,
};

use crate::{
    kerning::Kerning,
    mask::Mask,
    outline::{Contours, Flattener},
};

/// How outlines are fitted to the rows of pixels.
#[derive(Debug, Copy, Clone, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Hinting {
    /// Outlines as they were drawn
    #[default]
    None,
    /// Stems and heights are moved to whole rows; columns stay as they are
    Vertical,
}

/// What a font is converted to.
#[derive(Debug, Clone)]
pub struct Options {
    /// Pixels of the em square.
    pub size: f32,
    /// The characters, sorted.
    pub characters: Vec<char>,
    /// Whether outlines are fitted to rows.
    pub hinting: Hinting,
    /// Whether kerning is read.
    pub kerning: bool,
    /// What is drawn for characters that the font does not have; one of `characters`.
    pub replacement: Option<char>,
}

/// Sizes that are converted: pixels of the em square.
const SIZES: std::ops::RangeInclusive<f32> = 4.0..=300.0;

/// A glyph.
#[derive(Debug, Clone)]
pub struct Glyph {
    /// What the glyph is for.
    pub character: char,
    /// How much of each pixel it covers.
    pub mask: Mask,
    /// How far the pen moves on, in 1/16 pixel.
    pub advance: u16,
}

/// A pair of glyphs by their indices, and what is added to the advance between them in 1/16 pixel.
pub type Pair = (u16, u16, i16);

/// Where a decoration is: the row below the baseline in which it begins, and its rows.
#[derive(Debug, Copy, Clone)]
pub struct Decoration {
    /// Rows from the baseline to the first row.
    pub offset: i32,
    /// Rows.
    pub height: u32,
}

/// A converted font.
#[derive(Debug, Clone)]
pub struct Converted {
    /// The names that the font gives itself: family, style, copyright, licence, and where the licence is.
    pub names: Names,
    /// The glyphs, in the order of their characters.
    pub glyphs: Vec<Glyph>,
    /// Pairs of glyphs that are kerned, sorted.
    pub kerning: Vec<Pair>,
    /// Rows above the baseline in which glyphs may have pixels.
    pub above: u16,
    /// Rows below it.
    pub below: u16,
    /// Rows from line to line.
    pub line_height: u16,
    /// The underline.
    pub underline: Decoration,
    /// The strikethrough.
    pub strikethrough: Decoration,
}

/// What a font's name table says.
#[derive(Debug, Clone, Default)]
pub struct Names {
    /// Family, such as "DejaVu Sans".
    pub family: String,
    /// Style within the family, such as "Book".
    pub style: String,
    /// Copyright notice.
    pub copyright: String,
    /// Licence.
    pub licence: String,
    /// Address of the licence.
    pub licence_url: String,
}

impl Names {
    pub(crate) fn of(font: &FontRef<'_>) -> Self {
        let name = |id| {
            let name: String = font
                .localized_strings(id)
                .english_or_first()
                .map(|name| name.chars().take(20_000).collect())
                .unwrap_or_default();
            // Line ends and tabs become spaces, and what is no text nothing.
            let words: Vec<String> = name
                .split_whitespace()
                .map(|word| word.chars().filter(|character| !character.is_control()).collect())
                .collect();
            words.join(" ")
        };
        let family = name(StringId::FAMILY_NAME);
        Self {
            family: if family.is_empty() { "Font".to_owned() } else { family },
            style: name(StringId::SUBFAMILY_NAME),
            copyright: name(StringId::COPYRIGHT_NOTICE),
            licence: name(StringId::LICENSE_DESCRIPTION),
            licence_url: name(StringId::LICENSE_URL),
        }
    }
}

/// A font file that can be read.
pub struct Source<'a> {
    pub(crate) font: FontRef<'a>,
    pub(crate) outlines: OutlineGlyphCollection<'a>,
    /// Font units of the em square.
    pub(crate) units_per_em: f64,
}

impl<'a> Source<'a> {
    /// Reads the tables of a font file; of a collection, those of its first font.
    ///
    /// # Errors
    /// A file that is no TrueType or OpenType font.
    pub fn new(bytes: &'a [u8]) -> anyhow::Result<Self> {
        if bytes.starts_with(b"wOFF") || bytes.starts_with(b"wOF2") {
            bail!("it is a web font: unpack it to TTF or OTF first");
        }
        let font =
            FontRef::from_index(bytes, 0).context("it is no TrueType or OpenType font: pass a TTF or OTF file")?;
        let units = font.metrics(Size::unscaled(), LocationRef::default()).units_per_em;
        ensure!(
            (16..=16_384).contains(&units),
            "its em square has {units} units, where a font has 16 to 16,384: the file is broken, pass another one"
        );
        let outlines = font.outline_glyphs();
        ensure!(
            outlines.format().is_some(),
            "it has no outlines: pass a font with a table glyf, CFF or CFF2"
        );
        Ok(Self {
            font,
            outlines,
            units_per_em: units.into(),
        })
    }

    /// The glyph of each character.
    pub(crate) fn glyph_ids(&self, characters: &[char]) -> anyhow::Result<Vec<GlyphId>> {
        let charmap = self.font.charmap();
        let ids: Vec<Option<GlyphId>> = characters.iter().map(|&character| charmap.map(character)).collect();
        let missing: Vec<String> = characters
            .iter()
            .zip(&ids)
            .filter(|(_, id)| id.is_none())
            .map(|(character, _)| format!("{character:?}"))
            .collect();
        ensure!(
            missing.is_empty(),
            "it has no glyph for {}{}: leave them out of --chars, or pass a font that has them",
            missing[..missing.len().min(20)].join(", "),
            if missing.len() > 20 { " and others" } else { "" }
        );
        Ok(ids.into_iter().flatten().collect())
    }

    /// The flattened outline of a glyph in a size.
    fn contours(&self, id: GlyphId, size: f32, hinting: Option<&HintingInstance>) -> anyhow::Result<Contours> {
        let outline = self.outlines.get(id).context("its outline is missing")?;
        let mut pen = match hinting {
            // Points are scaled in 64 bits here, where the library would round them to 1/64 pixel.
            None => Flattener::new(f64::from(size) / self.units_per_em),
            Some(_) => Flattener::new(1.0),
        };
        let settings = match hinting {
            None => DrawSettings::unhinted(Size::unscaled(), LocationRef::default()),
            Some(instance) => DrawSettings::hinted(instance, false),
        };
        outline.draw(settings, &mut pen).context("its outline cannot be read")?;
        Ok(pen.contours())
    }

    /// The outline of a character in a size, as it is converted.
    ///
    /// # Errors
    /// A character without a glyph, and a glyph that cannot be read.
    pub fn outline_of(&self, character: char, size: f32, hinting: Hinting) -> anyhow::Result<Contours> {
        let ids = self.glyph_ids(&[character])?;
        let instance = self.hinting(size, hinting)?;
        self.contours(ids[0], size, instance.as_ref())
    }

    fn hinting(&self, size: f32, hinting: Hinting) -> anyhow::Result<Option<HintingInstance>> {
        if hinting == Hinting::None {
            return Ok(None);
        }
        let options = HintingOptions {
            engine: Engine::AutoFallback,
            target: Target::Smooth {
                mode: SmoothMode::Light,
                symmetric_rendering: false,
                // Nothing moves from column to column.
                preserve_linear_metrics: true,
            },
        };
        let instance = HintingInstance::new(&self.outlines, Size::new(size), LocationRef::default(), options);
        Ok(Some(instance.context(
            "its instructions for hinting cannot be run: convert it with --hinting none",
        )?))
    }

    /// Converts the chosen characters.
    ///
    /// # Errors
    /// Each says what to do: characters without a glyph, glyphs that are too large or cannot be read, sizes out of range.
    pub fn convert(&self, options: &Options) -> anyhow::Result<Converted> {
        ensure!(
            SIZES.contains(&options.size),
            "--size is {}: choose one from {} to {} pixels",
            options.size,
            SIZES.start(),
            SIZES.end()
        );
        ensure!(
            !options.characters.is_empty(),
            "there are no characters: name some with --chars"
        );
        let ids = self.glyph_ids(&options.characters)?;
        let hinting = self.hinting(options.size, options.hinting)?;
        let metrics = self.font.glyph_metrics(Size::unscaled(), LocationRef::default());
        let sixteenths = |units: f64| (units * f64::from(options.size) / self.units_per_em * 16.0).round();
        let mut glyphs = Vec::new();
        for (&character, &id) in options.characters.iter().zip(&ids) {
            let advance = sixteenths(metrics.advance_width(id).unwrap_or_default().into());
            let mask = self
                .contours(id, options.size, hinting.as_ref())
                .and_then(|contours| Mask::of(&contours))
                .with_context(|| format!("the glyph of {character:?} cannot be converted"))?;
            glyphs.push(Glyph {
                character,
                mask,
                advance: advance.clamp(0.0, u16::MAX.into()) as u16,
            });
        }
        let kerning = if options.kerning {
            self.pairs(&ids, |units| sixteenths(units.into()))?
        } else {
            Vec::new()
        };
        Ok(self.with_metrics(options, glyphs, kerning))
    }

    /// The pairs of glyphs that are kerned, with their adjustments in whole units of the result.
    pub(crate) fn pairs(&self, ids: &[GlyphId], rounded: impl Fn(i32) -> f64) -> anyhow::Result<Vec<Pair>> {
        let kerning = Kerning::of(&self.font)?;
        let mut pairs = Vec::new();
        for (left, &left_id) in (0u16..).zip(ids) {
            for (right, &right_id) in (0u16..).zip(ids) {
                let adjustment = rounded(kerning.between(left_id, right_id));
                if adjustment != 0.0 {
                    pairs.push((left, right, adjustment as i16));
                }
            }
        }
        Ok(pairs)
    }

    fn with_metrics(&self, options: &Options, glyphs: Vec<Glyph>, kerning: Vec<Pair>) -> Converted {
        let metrics = self.font.metrics(Size::new(options.size), LocationRef::default());
        let rows = |pixels: f32| pixels.round().clamp(0.0, 1000.0) as i32;
        let covered = || {
            glyphs
                .iter()
                .map(|glyph| glyph.mask.window)
                .filter(|window| !window.is_empty())
        };
        let above = covered()
            .map(|window| -window.top)
            .max()
            .unwrap_or(0)
            .max(rows(metrics.ascent));
        let below = covered()
            .map(|window| window.bottom)
            .max()
            .unwrap_or(0)
            .max(rows(-metrics.descent));
        let decoration = |decoration: Option<skrifa::metrics::Decoration>, otherwise: f32| {
            let offset = decoration.map_or(otherwise, |decoration| -decoration.offset);
            let thickness = decoration.map_or(options.size / 16.0, |decoration| decoration.thickness);
            Decoration {
                // Not above the line, and not far below it.
                offset: (offset.round().clamp(-1000.0, 1000.0) as i32).max(-above),
                height: rows(thickness).max(1) as u32,
            }
        };
        Converted {
            names: Names::of(&self.font),
            glyphs,
            kerning,
            above: above as u16,
            below: below as u16,
            line_height: rows(metrics.ascent - metrics.descent + metrics.leading).max(1) as u16,
            underline: decoration(metrics.underline, options.size / 8.0),
            strikethrough: decoration(metrics.strikeout, -options.size / 4.0),
        }
    }
}
