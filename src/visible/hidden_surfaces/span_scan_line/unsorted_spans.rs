//! Rows with more faces than there is room for: their spans are visited in any order, twice for each interval.

use crate::{
    shade::Shading,
    view::{DepthWidth, ScreenPrecision},
    visible::{
        face_table::FaceTable,
        hidden_surfaces::{
            placed::face_from_row,
            span_scan_line::{comparison::Comparison, row_span::RowSpan},
        },
        painter::Painter,
        passes::for_each_crossing,
    },
};

/// Visits all spans of a row, in any order.
type Visit<'v> = dyn FnMut(&RowSpan) + 'v;

/// Hands over the faces that are seen in a row of so many columns, all of which are active.
#[cold]
#[inline(never)]
pub(super) fn draw_unsorted<S: ScreenPrecision, D: DepthWidth, H: Shading, P: Painter<S, H>>(
    comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
    row: i32,
    width: i32,
    painter: &mut P,
) {
    let visit_all = |painter: &mut P, visit: &mut Visit<'_>| {
        let active = painter.active().map(|list| list.in_use()).unwrap_or_default();
        for (slot, face) in (0..).zip(active) {
            visit(&RowSpan::of(face, slot, row, width));
        }
    };
    let paint = |painter: &mut P, span: &RowSpan, columns| painter.span_of_active(span.slot(), row, columns);
    draw(comparison, width, painter, visit_all, paint);
}

/// Hands over the faces that are seen in a row of so many columns, none of which is active: each is set up for each visit.
#[cold]
#[inline(never)]
pub(super) fn draw_set_up_anew<S: ScreenPrecision, D: DepthWidth, H: Shading, P: Painter<S, H>>(
    comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
    at: [i32; 2],
    width: i32,
    painter: &mut P,
) {
    let (faces, [_, row]) = (comparison.faces, at);
    let visit_all = |_: &mut P, visit: &mut Visit<'_>| {
        for_each_crossing(faces, at, &|_| true, &mut |face| {
            visit(&RowSpan::of(face, 0, row, width));
        });
    };
    let paint = |painter: &mut P, span: &RowSpan, columns| {
        if let Some((face, _)) = face_from_row(faces, span.node, at) {
            painter.span(&face, row, columns);
        }
    };
    draw(comparison, width, painter, visit_all, paint);
}

/// Hands over the faces that are seen in a row of so many columns.
fn draw<S: ScreenPrecision, D: DepthWidth, H: Shading, P>(
    comparison: &mut Comparison<'_, S, D, H, impl FaceTable<S, D, H>>,
    width: i32,
    painter: &mut P,
    visit_all: impl Fn(&mut P, &mut Visit<'_>),
    paint: impl Fn(&mut P, &RowSpan, [i32; 2]),
) {
    let mut column = 0;
    while column < width {
        let (mut nearest, mut next) = (None, width);
        visit_all(painter, &mut |span| {
            if column < span.first() {
                next = next.min(span.first());
            } else {
                nearest = comparison.nearer(nearest, span, column);
            }
        });
        let Some(nearest) = nearest else {
            column = next;
            continue;
        };
        let mut end = nearest.after();
        visit_all(painter, &mut |other| {
            if other.node != nearest.node {
                end = comparison.end_before(&nearest, other, column.max(other.first()), end);
            }
        });
        comparison.count_interval();
        paint(painter, &nearest, [column, end]);
        column = end;
    }
}
