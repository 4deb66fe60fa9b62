//! Half planes and sectors of a row.

use anyhow::ensure;
use arbitrary::Arbitrary;
use zrow::scan::round::plane_sector::{Columns, PlaneSector, runs};

use crate::{
    target::{Case, Verdict},
    values::{Degrees, Int, List, Stage},
};

/// Pieces and runs of a row.
#[derive(Debug, Arbitrary)]
pub struct SectorCase {
    stage: Stage,
    angles: [Degrees; 2],
    beyond: i32,
    pieces: [[Int; 2]; 2],
    borders: List<i8, 8>,
    kinds: u16,
}

impl Case for SectorCase {
    fn check(&self) -> Verdict {
        let [start, sweep] = self.angles.map(Degrees::as_radians);
        let sector = PlaneSector::new(start, sweep);
        let _ = sector.half_planes(self.beyond.into());
        let columns = |[start, end]: [Int; 2]| Columns {
            start: start.0,
            end: end.0,
        };
        let visible = Columns {
            start: self.stage.window.left,
            end: self.stage.window.right,
        };
        let parts = self.pieces.map(columns).map(|part| part.intersection(visible));
        let pieces = sector.row_runs(parts, visible);
        for x in visible.start..visible.end {
            let inside = sector.contains(&parts, x);
            let found = pieces.iter().filter(|piece| piece.contains(x)).count();
            ensure!(
                found == usize::from(inside),
                "column {x} is in {found} of {pieces:?}, inside is {inside}"
            );
        }
        // Runs of one kind, between borders where the kind may change.
        let mut borders: Vec<i32> = self
            .borders
            .0
            .iter()
            .map(|border| visible.start.saturating_add((*border).into()))
            .collect();
        let before = borders.clone();
        let kind = |x: i32| {
            let index = before.iter().filter(|border| **border <= x).count();
            // Left of the first border nothing is of any kind.
            if index == 0 {
                None
            } else {
                Some(self.kinds >> (2 * index % 16) & 3).filter(|kind| *kind > 0)
            }
        };
        let mut found = Vec::new();
        let result = runs(visible, &mut borders, kind, |columns, kind| {
            found.push((columns, kind));
            Ok::<(), ()>(())
        });
        ensure!(result == Ok(()), "an error that nobody told");
        ensure!(
            found.len() <= before.len() + 1,
            "{} runs between {} borders",
            found.len(),
            before.len()
        );
        let first = before.iter().filter(|border| visible.contains(**border)).min();
        for x in visible.start..visible.end {
            let of: Vec<_> = found.iter().filter(|(columns, _)| columns.contains(x)).collect();
            // What is left of the first border that is visible is of no kind.
            let expected = kind(x).filter(|_| first.is_some_and(|first| x >= *first));
            let kinds: Vec<_> = of.iter().map(|(_, kind)| *kind).collect();
            ensure!(
                kinds == expected.into_iter().collect::<Vec<_>>(),
                "column {x} is of {kinds:?}, not {expected:?}"
            );
        }
        Ok(())
    }
}
