//! `zrow::coverage::AntialiasedEdge`: where an antialiased edge crosses rows, exactly.

use anyhow::ensure;
use arbitrary::Arbitrary;
use zrow::{
    coverage::{AntialiasedEdge, RowSegment},
    geometry::{Sub8, SubPoint},
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{Int, Number, Stage, SubSpot},
};

/// An edge that is cut into a segment for each row of pixels.
#[derive(Debug, Arbitrary)]
pub struct EdgeCase {
    stage: Stage,
    points: [SubSpot; 2],
    row: Number<u32>,
    any_row: Int,
    ordinate: u8,
}

impl Case for EdgeCase {
    fn check(&self) -> Verdict {
        let [from, to]: [SubPoint<Sub8>; 2] = self.points.map(|point| point.inside(&self.stage));
        let units = |point: SubPoint<Sub8>| {
            // From the corner of a pixel, where a point is given from its centre.
            [point.x_units(), point.y_units()].map(|units| i128::from(units) + 128)
        };
        let (a, b) = (units(from), units(to));
        let Some(edge) = AntialiasedEdge::new(&from, &to) else {
            ensure!(a[1] == b[1], "no edge, where there is height");
            return Ok(());
        };
        let (top, bottom) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let unit = i128::from(RowSegment::Y_ONE);
        let (first, end) = (top[1].div_euclid(unit), -((-bottom[1]).div_euclid(unit)));
        ensure!(
            (i128::from(edge.first_row()), i128::from(edge.end_row())) == (first, end),
            "rows {}..{}, exactly {first}..{end}",
            edge.first_row(),
            edge.end_row()
        );
        let fine = i128::from(RowSegment::X_ONE / RowSegment::Y_ONE);
        let (dx, dy) = (bottom[0] - top[0], bottom[1] - top[1]);
        // Where it passes an ordinate, in fine units, rounded to the nearest.
        let column = |y: i128| fine * top[0] + exact::nearest(fine * dx * (y - top[1]), dy);
        let row = first + i128::from(self.row.0) % (end - first);
        let mut segment = edge.begin(row as i32);
        for row in row..end.min(row + 3) {
            let (from_y, to_y) = (top[1].max(row * unit), bottom[1].min((row + 1) * unit));
            ensure!(
                (i128::from(segment.top().1), i128::from(segment.bottom().1))
                    == (from_y - row * unit, to_y - row * unit),
                "{segment:?} in row {row}, exactly {from_y} to {to_y}"
            );
            let columns = (i128::from(segment.top().0), i128::from(segment.bottom().0));
            ensure!(
                columns == (column(from_y), column(to_y)),
                "{columns:?} in row {row}, exactly {} and {}",
                column(from_y),
                column(to_y)
            );
            let ends = segment.ends();
            ensure!(
                ends == (
                    segment.top().0.min(segment.bottom().0),
                    segment.top().0.max(segment.bottom().0)
                ),
                "{ends:?} in row {row}"
            );
            let height = (to_y - from_y) as i32;
            ensure!(
                segment.signed_height() == (height << 6) * segment.winding(),
                "height {}",
                segment.signed_height()
            );
            let ordinate = segment.top().1 + i32::from(self.ordinate) * height / 255;
            let x = segment.x_at(ordinate);
            ensure!(ends.0 <= x && x <= ends.1, "{x} at {ordinate} is beside {ends:?}");
            // Steps lead from a whole row to a whole row.
            if i128::from(segment.last_row()) <= row + 1 || segment.top().1 > 0 {
                break;
            }
            segment.step();
        }
        // Any row, and what follows on it.
        let mut segment = edge.begin(self.any_row.0);
        segment.step();
        let _ = (
            segment.x_at(i32::from(self.ordinate)),
            segment.ends(),
            segment.last_row(),
        );
        Ok(())
    }
}
