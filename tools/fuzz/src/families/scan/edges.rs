//! Edges by themselves: where they cross rows, exactly.

use anyhow::ensure;
use arbitrary::Arbitrary;
use embedded_graphics::geometry::Point;
use zrow::{
    coverage::edges::{AntialiasedEdge, X_ONE, Y_ONE},
    geometry::{Sub4, Sub8, SubPoint, Vertex},
    scan::polygon::{Edge, Part},
};

use crate::{
    exact,
    target::{Case, Verdict},
    values::{ByHand, Int, Number, Spot, Stage, SubSpot},
};

/// An edge between two vertices of any kind.
#[derive(Debug, Arbitrary)]
pub struct EdgeCase {
    stage: Stage,
    pixels: [Spot; 2],
    points: [SubSpot; 2],
    row: Number<u32>,
    any_row: Int,
}

impl EdgeCase {
    fn check_between<V: Vertex>(&self, from: V, to: V) -> Verdict {
        let units = |vertex: V| [i128::from(vertex.x_units()), i128::from(vertex.y_units())];
        let (a, b) = (units(from), units(to));
        let one = 1i128 << V::FRACTION_BITS;
        let ceil = |units: i128| -((-units).div_euclid(one));
        let (top, bottom) = if a[1] < b[1] { (a, b) } else { (b, a) };
        let (first, end) = (ceil(top[1]), ceil(bottom[1]));
        let Some(edge) = Edge::new(&from, &to, Part::Fill) else {
            ensure!(first >= end, "no edge, where rows {first}..{end} are crossed");
            return Ok(());
        };
        ensure!(
            (i128::from(edge.first_row), i128::from(edge.end_row)) == (first, end),
            "{edge:?}, where rows {first}..{end} are crossed"
        );
        ensure!(
            Edge::new(&to, &from, Part::Fill)
                .is_some_and(|other| { other.crossing == edge.crossing && other.fill_winding == -edge.fill_winding }),
            "the other direction is another edge"
        );
        // The first pixel whose centre is on the edge or right of it, in some row and the one after it.
        let expected = |row: i128| {
            let (dx, dy) = (bottom[0] - top[0], bottom[1] - top[1]);
            let numerator = top[0] * dy + (row * one - top[1]) * dx;
            -((-numerator).div_euclid(dy * one))
        };
        let row = first + i128::from(self.row.0) % (end - first);
        let crossing = edge.crossing_at(row as i32);
        ensure!(
            i128::from(crossing.x) == expected(row),
            "{crossing:?} in row {row}, exactly {}",
            expected(row)
        );
        if row + 1 < end {
            let next = edge.next_crossing(crossing);
            ensure!(next == edge.crossing_at(row as i32 + 1), "{next:?} from row to row");
            ensure!(i128::from(next.x) == expected(row + 1), "{next:?} in row {}", row + 1);
        }
        let any = edge.crossing_at(self.any_row.0);
        let _ = edge.next_crossing(any);
        Ok(())
    }

    fn check_sub<S: ByHand>(&self) -> Verdict {
        let [from, to] = self.points.map(|point| point.by_hand::<S>(&self.stage));
        self.check_between(from, to)
    }
}

impl Case for EdgeCase {
    fn check(&self) -> Verdict {
        let [from, to]: [Point; 2] = self.pixels.map(|pixel| self.stage.point(pixel));
        self.check_between(from, to)?;
        self.check_sub::<Sub4>()?;
        self.check_sub::<Sub8>()
    }
}

/// An edge that is cut into a segment for each row of pixels.
#[derive(Debug, Arbitrary)]
pub struct SubEdgeCase {
    stage: Stage,
    points: [SubSpot; 2],
    row: Number<u32>,
    any_row: Int,
    ordinate: u8,
}

impl Case for SubEdgeCase {
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
        let unit = i128::from(Y_ONE);
        let (first, end) = (top[1].div_euclid(unit), -((-bottom[1]).div_euclid(unit)));
        ensure!(
            (i128::from(edge.first_row()), i128::from(edge.end_row())) == (first, end),
            "rows {}..{}, exactly {first}..{end}",
            edge.first_row(),
            edge.end_row()
        );
        let fine = i128::from(X_ONE / Y_ONE);
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
