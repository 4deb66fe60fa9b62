use embedded_graphics::pixelcolor::Rgb565;
use zrow::{
    band::{BigEndian, LittleEndian, Order},
    scan::Polygons,
    scene::{
        Antialiased, Deep, DepthWidth, DoubleSided, Fine, Look, Memory, OnePass, Prepared, SceneItem, VisibleBy, Whole,
    },
    shade::{CutOut, Gouraud, Indexed, Texels, Textured, Translucent},
    visible::{
        Appel, Comparison, DepthBuffer, DepthLine, DepthPolygon, DepthSort, DepthSortCounters, DepthState,
        FaceAgainstSegment, GridRayCasting, HiddenLines, LinePart, OneDepth, PartKind, PolygonOffset, RayCasting,
        Roberts, SolidCombination, SolidNode, SpanScanLine, TileBins, Visibility, Warnock, Work,
    },
};
use zrow_panics_firmware::{any, keep, keep_all};

use crate::{
    foreign::{clone, default, eq},
    scene::{picture_item, row_target},
};

pub const EXERCISES: &[fn()] = &[
    methods::<Rgb565, BigEndian>,
    methods::<Fine<Deep<Textured<Texels<Rgb565, 64, 64>>>>, LittleEndian>,
    hidden_lines::<Rgb565>,
    hidden_lines::<Fine<Deep<Textured<Texels<Rgb565, 64, 64>>>>>,
    solids::<DoubleSided<Rgb565>, BigEndian>,
    solids::<DoubleSided<Fine<Deep<Textured<Texels<Rgb565, 64, 64>>>>>, LittleEndian>,
    depth_test::<Rgb565, BigEndian>,
    depth_test::<Fine<Deep<Textured<Texels<Rgb565, 64, 64>>>>, LittleEndian>,
    depth_test::<Whole<OnePass<Translucent<Gouraud<Rgb565>>>>, LittleEndian>,
    named::<VisibleBy<OneDepth, Rgb565>, BigEndian>,
    named::<Fine<VisibleBy<SpanScanLine<30>, Textured<Texels<Rgb565, 64, 64>>>>, LittleEndian>,
    named::<VisibleBy<DepthSort<500, 40>, Antialiased<Translucent<Gouraud<Rgb565>>>>, BigEndian>,
    named_method,
    painted::<Translucent<Gouraud<Rgb565>>, BigEndian>,
    painted::<Fine<Deep<Translucent<Textured<CutOut<Indexed<Rgb565, 16, 64, 16>>>>>>, LittleEndian>,
    painted::<Antialiased<Rgb565>, LittleEndian>,
    painted::<Antialiased<Fine<Deep<Translucent<Textured<CutOut<Indexed<Rgb565, 16, 64, 16>>>>>>>, BigEndian>,
    depth_values::<u16>,
    depth_values::<u32>,
];

/// What is drawn into the rows of a scene by a state of the depth test.
#[inline(never)]
fn depth_test<L: Look, O: Order + 'static>() {
    keep(Prepared::<L>::draw_with::<O>(any(), any(), |row| {
        keep(row.depths());
        row.draw_line(any(), any(), any());
        row.draw_polygon::<5>(any(), any(), any());
        keep(Prepared::<L>::draw_in(any(), row, any()));
        row_target(row.at_depth_with(any(), any()));
    }));
    keep_all(Prepared::<L>::lines_in_depth(any(), any(), any()));
    keep(Prepared::<L>::prepare_polygon::<5>(any(), any(), any(), any(), any()));
}

#[inline(never)]
fn depth_values<D: DepthWidth + 'static>() {
    keep(DepthLine::<D>::new(any()));
    clone::<DepthLine<D>>();
    keep(DepthPolygon::<D, 5>::new());
    default::<DepthPolygon<D, 5>>();
    clone::<DepthPolygon<D, 5>>();
    eq::<DepthLine<D>>();
    default::<DepthState<D>>();
    clone::<DepthState<D>>();
    eq::<DepthState<D>>();
    default::<PolygonOffset>();
    clone::<PolygonOffset>();
    eq::<PolygonOffset>();
    keep(Comparison::passes::<D>(any(), any(), any()));
    keep(Comparison::opposite(any()));
    default::<Comparison>();
    clone::<Comparison>();
    eq::<Comparison>();
}

/// Each method in a look.
#[inline(never)]
fn methods<L: Look, O: Order + 'static>() {
    keep(Prepared::<L>::face_at(any(), any()));
    let mut grid = GridRayCasting::<500, 900, 2_000>::new();
    if let Ok(mut face_at) = Prepared::<L>::picking(any(), &mut grid) {
        keep(face_at(any()));
    }
    clone::<Work>();
    eq::<Work>();

    keep(DepthBuffer::<L::Depth, 4_800>::new());
    default::<DepthBuffer<L::Depth, 4_800>>();
    visibility::<L, O, DepthBuffer<L::Depth, 4_800>>();

    keep(DepthSort::<500, 40>::new());
    keep(DepthSort::<500, 40>::counters(any()));
    default::<DepthSort<500, 40>>();
    clone::<DepthSortCounters>();
    default::<DepthSortCounters>();
    eq::<DepthSortCounters>();
    visibility::<L, O, DepthSort<500, 40>>();

    keep(GridRayCasting::<500, 1_000, 4_000>::new());
    keep(GridRayCasting::<500, 1_000, 4_000>::faces_tested(any()));
    keep(GridRayCasting::<500, 1_000, 4_000>::cells_visited(any()));
    keep(GridRayCasting::<500, 1_000, 4_000>::mailbox_hits(any()));
    default::<GridRayCasting<500, 1_000, 4_000>>();
    visibility::<L, O, GridRayCasting<500, 1_000, 4_000>>();

    keep(OneDepth::new(Polygons::winding_number));
    keep(OneDepth::points_tested(any()));
    visibility::<L, O, OneDepth>();

    keep(RayCasting::<500>::new());
    keep(RayCasting::<500>::faces_tested(any()));
    default::<RayCasting<500>>();
    visibility::<L, O, RayCasting<500>>();

    keep(SpanScanLine::<64>::new());
    keep(SpanScanLine::<64>::intervals(any()));
    keep(SpanScanLine::<64>::splits(any()));
    keep(SpanScanLine::<64>::comparisons(any()));
    keep(SpanScanLine::<64>::pixels_compared(any()));
    default::<SpanScanLine<64>>();
    visibility::<L, O, SpanScanLine<64>>();

    keep(TileBins::<L::Depth, 300, 2_000>::new());
    default::<TileBins<L::Depth, 300, 2_000>>();
    visibility::<L, O, TileBins<L::Depth, 300, 2_000>>();

    keep(Warnock::<500>::new());
    keep(Warnock::<500>::windows(any()));
    keep(Warnock::<500>::blocks(any()));
    keep(Warnock::<500>::pixels_compared(any()));
    default::<Warnock<500>>();
    visibility::<L, O, Warnock<500>>();
    keep(Warnock::<500, _>::by_line_equations());
    keep(Warnock::<500, _>::by_ray_crossings());
    keep(Warnock::<500, _>::by_angle_sum());
    keep(Warnock::<500, _>::by_region_codes());
}

/// Each method of hidden lines in a look.
#[inline(never)]
fn hidden_lines<L: Look>() {
    eq::<LinePart<L::Precision>>();
    keep(LinePart::<L::Precision>::pixels(any()));
    eq::<PartKind>();

    keep(FaceAgainstSegment::<500, 16, true>::new());
    keep(FaceAgainstSegment::<500, 16, true>::faces_tested(any()));
    keep(FaceAgainstSegment::<500, 16, true>::segments_repeated(any()));
    default::<FaceAgainstSegment<500, 16, true>>();
    visible_parts::<L, FaceAgainstSegment<500, 16, true>>();

    keep(Roberts::<8, 200>::new());
    keep(Roberts::<8, 200>::pairs(any()));
    keep(Roberts::<8, 200>::boxes_apart(any()));
    keep(Roberts::<8, 200>::inequalities(any()));
    default::<Roberts<8, 200>>();
    visible_parts::<L, Roberts<8, 200>>();

    keep(Appel::<200, 8, 300>::new());
    keep(Appel::<200, 8, 300>::rays(any()));
    keep(Appel::<200, 8, 300>::edges(any()));
    keep(Appel::<200, 8, 300>::contours(any()));
    default::<Appel<200, 8, 300>>();
    visible_parts::<L, Appel<200, 8, 300>>();
    visible_parts::<L, Appel<0, 0, 0>>();
    visible_parts::<L, Appel<200, 8, 300, true>>();
}

#[inline(never)]
fn visible_parts<L: Look, V: HiddenLines<L::Depth> + 'static>() {
    keep(Prepared::<L>::visible_parts(any(), any::<&mut V>(), any(), |part| {
        keep(part)
    }));
}

/// A look that names a method.
#[inline(never)]
fn named<L: Look<Color = Rgb565>, O: Order + 'static>() {
    keep(Memory::<L, 300, 600, 240, 240, 30>::frame(any()));
    keep(Prepared::<L>::draw::<O>(any(), any()));
    picture_item::<Rgb565, O, SceneItem<L, 2>>();
}

/// What a look that names a method says of it.
#[inline(never)]
fn named_method() {
    keep(Prepared::<VisibleBy<OneDepth, Rgb565>>::method(any()));
    keep(Prepared::<VisibleBy<OneDepth, Rgb565>>::method_error(any()));
    keep(SceneItem::<VisibleBy<OneDepth, Rgb565>, 2>::method_error(any()));
}

/// Translucent faces, holes and antialiased silhouettes, from back to front.
#[inline(never)]
fn painted<L: Look, O: Order + 'static>() {
    visibility::<L, O, DepthSort<500, 40>>();
    visibility::<L, O, DepthSort<0, 0>>();
}

/// Combined solids in a look with backs.
#[inline(never)]
fn solids<L: Look, O: Order + 'static>() {
    clone::<SolidNode>();
    eq::<SolidNode>();
    keep(SolidCombination::<500, 8>::new(any()));
    keep(SolidCombination::<500, 8>::passes(any()));
    keep(SolidCombination::<500, 8>::faces_tested(any()));
    visibility::<L, O, SolidCombination<'static, 500, 8>>();
}

#[inline(never)]
fn visibility<L: Look, O: Order + 'static, V: Visibility<L::Depth> + 'static>() {
    keep(Prepared::<L>::draw_by::<O, V>(any(), any(), any()));
    keep(Prepared::<L>::draw_by_with::<O, V>(any(), any(), any(), |work| {
        keep(work);
    }));
}
