//! Face against segment.

use crate::{
    geometry::TooSmall,
    view::{DepthWidth, ScreenPrecision},
    visible::hidden_lines::{
        hiding::HidingFace,
        line_part::LinePart,
        line_table::LineTable,
        method::Method,
        parts::{END, PartedLine, Parts},
    },
};

/// Face against segment ([`HiddenLines`](crate::visible::HiddenLines)).
#[derive(Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct FaceAgainstSegment;

impl<D: DepthWidth> Method<D> for FaceAgainstSegment {
    fn visible_parts<S, T>(&mut self, table: &T, part: &mut impl FnMut(LinePart<S>)) -> Result<(), TooSmall>
    where
        S: ScreenPrecision,
        T: LineTable<S, D>,
    {
        for edge in table.edges() {
            let mut parts = Parts::new(PartedLine::of(&edge), part);
            let mut start = 0;
            while start < END {
                let mut segment = [start, END];
                for face in table.faces().filter(|face| face.is_seen) {
                    let hidden = HidingFace::new(face.corners).and_then(|face| face.hidden::<D>(edge.ends));
                    let Some([from, to]) = hidden else { continue };
                    if to <= segment[0] || from >= segment[1] {
                        continue;
                    }
                    if from <= segment[0] {
                        segment[0] = to;
                    } else {
                        segment[1] = from;
                    }
                }
                let [from, to] = segment;
                parts.until(from.min(END), true);
                parts.until(to.max(from), false);
                start = to.max(from);
            }
            parts.finish();
        }
        Ok(())
    }
}
