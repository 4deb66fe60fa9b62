//! Kerning between two glyphs: from the `kern` feature of `GPOS` where a font has one, otherwise from the table `kern`.

use anyhow::ensure;
use skrifa::{
    FontRef, GlyphId, GlyphId16, Tag,
    raw::{
        TableProvider,
        tables::{
            gpos::{Gpos, PairPos, PositionSubtables},
            kern::SubtableKind,
        },
    },
};

/// Tables of pairs that are read at most; fonts have some dozens.
const MOST_TABLES: usize = 1024;

/// The kerning of a font, for text from left to right in Latin letters.
pub enum Kerning<'a> {
    /// Lookups, each of which adds what its first table with the pair says.
    Gpos(Vec<Vec<PairPos<'a>>>),
    /// Tables whose values are added.
    Kern(Vec<SubtableKind<'a>>),
}

impl<'a> Kerning<'a> {
    /// Finds the kerning of a font; what cannot be read has none.
    ///
    /// # Errors
    /// More tables than any font has.
    pub fn of(font: &FontRef<'a>) -> anyhow::Result<Self> {
        let lookups = font.gpos().ok().and_then(|gpos| lookups(&gpos)).unwrap_or_default();
        let tables: usize = lookups.iter().map(Vec::len).sum();
        let kerning = if tables > 0 {
            Self::Gpos(lookups)
        } else {
            Self::Kern(kern_tables(font))
        };
        let tables = match &kerning {
            Self::Gpos(_) => tables,
            Self::Kern(tables) => tables.len(),
        };
        ensure!(
            tables <= MOST_TABLES,
            "the font has {tables} tables of kerning: convert it with --no-kerning"
        );
        Ok(kerning)
    }

    /// What is added to the advance of the left glyph, in font units.
    pub fn between(&self, left: GlyphId, right: GlyphId) -> i32 {
        match self {
            Self::Gpos(lookups) => lookups
                .iter()
                .filter_map(|tables| tables.iter().find_map(|table| adjustment(table, left, right)))
                .sum(),
            Self::Kern(tables) => tables.iter().filter_map(|table| value(table, left, right)).sum(),
        }
    }
}

/// The pair tables of each lookup of the `kern` feature, in the script of Latin letters or the default one.
fn lookups<'a>(gpos: &Gpos<'a>) -> Option<Vec<Vec<PairPos<'a>>>> {
    let scripts = gpos.script_list().ok()?;
    let record = [b"latn", b"DFLT"].into_iter().find_map(|tag| {
        let mut records = scripts.script_records().iter();
        records.find(|record| record.script_tag() == Tag::new(tag))
    })?;
    let script = record.script(scripts.offset_data()).ok()?;
    let features = gpos.feature_list().ok()?;
    let mut indices = Vec::new();
    for feature in script.default_lang_sys()?.ok()?.feature_indices() {
        let Some(record) = features.feature_records().get(usize::from(feature.get())) else {
            continue;
        };
        if record.feature_tag() == Tag::new(b"kern")
            && let Ok(feature) = record.feature(features.offset_data())
        {
            indices.extend(feature.lookup_list_indices().iter().map(|index| index.get()));
        }
    }
    indices.sort_unstable();
    indices.dedup();
    let lookups = gpos.lookup_list().ok()?.lookups();
    let tables = |index: u16| match lookups.get(usize::from(index)).ok()?.subtables().ok()? {
        PositionSubtables::Pair(tables) => Some(tables.iter().take(MOST_TABLES + 1).filter_map(Result::ok).collect()),
        _ => None,
    };
    Some(indices.into_iter().take(MOST_TABLES + 1).filter_map(tables).collect())
}

/// What a pair table says about a pair; `None` where the next table of the lookup is asked.
fn adjustment(table: &PairPos<'_>, left: GlyphId, right: GlyphId) -> Option<i32> {
    let advance = match table {
        PairPos::Format1(table) => {
            let index = table.coverage().ok()?.get(left)?;
            let pairs = table.pair_sets().get(usize::try_from(index).ok()?).ok()?;
            let record = pairs.find_pair_value_record(GlyphId16::try_from(right).ok()?)?;
            record.value_record1().x_advance()
        }
        PairPos::Format2(table) => {
            table.coverage().ok()?.get(left)?;
            let classes = (table.class_def1().ok()?.get(left), table.class_def2().ok()?.get(right));
            let [first, _] = table.value_record_refs(u16::try_from(classes.0).ok()?, u16::try_from(classes.1).ok()?)?;
            first.x_advance()
        }
        _ => return None,
    };
    Some(advance.unwrap_or(0).into())
}

fn kern_tables<'a>(font: &FontRef<'a>) -> Vec<SubtableKind<'a>> {
    let Ok(kern) = font.kern() else { return Vec::new() };
    let tables = kern.subtables().take(MOST_TABLES + 1).filter_map(Result::ok);
    let horizontal = tables.filter(|table| table.is_horizontal() && !table.is_cross_stream() && !table.is_variable());
    horizontal.filter_map(|table| table.kind().ok()).collect()
}

fn value(table: &SubtableKind<'_>, left: GlyphId, right: GlyphId) -> Option<i32> {
    match table {
        SubtableKind::Format0(table) => table.kerning(left, right),
        SubtableKind::Format2(table) => table.kerning(left, right),
        SubtableKind::Format3(table) => table.kerning(left, right),
        SubtableKind::Format1(_) => None,
    }
}
