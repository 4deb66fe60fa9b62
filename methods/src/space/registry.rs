//! The looks in which small scenes are drawn, an entry each: for the desktop and the chips.

/// A way to draw small scenes.
#[derive(Debug, Clone, Copy)]
pub struct SpaceMethod {
    /// The name of this entry in the report's tables.
    pub name: &'static str,
    /// The name of this entry in what the firmware on the emulated chips reports.
    pub variant: &'static str,
    /// The distance of the near plane.
    pub near: i32,
}

macro_rules! methods {
    (
        $dollar:tt
        $(
            $(#[$doc:meta])+
            $list:ident, $table:ident: [
                $([$variant:ident] [$($look:tt)+] $name:literal, $near:literal;)+
            ]
        )+
    ) => {$(
        $(#[$doc])+
        ///
        /// Calls a macro with `[variant] [look] name, distance of the near plane;` of each.
        #[macro_export]
        macro_rules! $list {
            ($dollar with:ident) => {
                $dollar with! { $([$variant] [$($look)+] $name, $near;)+ }
            };
        }

        $(#[$doc])+
        pub const $table: &[SpaceMethod] = &[$(SpaceMethod {
            name: $name,
            variant: stringify!($variant),
            near: $near,
        }),+];
    )+};
}

methods! { $
    /// Widths of depths and distances of the near plane.
    depth_widths, DEPTH_WIDTHS: [
        [u16_8] [$crate::space::Plain] "u16, near 8", 8;
        [u16_32] [$crate::space::Plain] "u16, near 32", 32;
        [u16_128] [$crate::space::Plain] "u16, near 128", 128;
        [u32_8] [zrow::scene::Deep<$crate::space::Plain>] "u32, near 8", 8;
        [u32_32] [zrow::scene::Deep<$crate::space::Plain>] "u32, near 32", 32;
        [u32_128] [zrow::scene::Deep<$crate::space::Plain>] "u32, near 128", 128;
        [fine_u32_8] [zrow::scene::Fine<zrow::scene::Deep<$crate::space::Plain>>] "u32 at 1/256 px, near 8", 8;
    ]
    /// Precisions of corners.
    positions, POSITIONS: [
        [sub4] [$crate::space::Plain] "1/16 px", 64;
        [sub4_wide] [zrow::scene::Deep<$crate::space::Plain>] "1/16 px, u32", 64;
        [sub8] [zrow::scene::Fine<$crate::space::Plain>] "1/256 px", 64;
    ]
    /// Formats of the matrix to eye space.
    matrix_formats, MATRIX_FORMATS: [
        [rows_14] [$crate::space::Plain] "2.14, 1/16 px", 64;
        [rows_24] [zrow::shade::Transformed<$crate::space::Plain>] "8.24, 1/16 px", 64;
        [fine_rows_24] [zrow::scene::Fine<zrow::shade::Transformed<$crate::space::Plain>>] "8.24, 1/256 px", 64;
        [fine_rows_30] [zrow::scene::Fine<$crate::space::Plain>] "2.30, 1/256 px", 64;
    ]
    /// How often texture coordinates are divided by the depth.
    perspectives, PERSPECTIVES: [
        [affine] [$crate::space::InSpace<65_535>] "affine", 64;
        [by_texel_error] [$crate::space::InSpace<24>] "every 16 px where 3/8 texel off", 64;
        [every_16] [$crate::space::InSpace<0>] "every 16 px", 64;
        [every_8] [$crate::space::InSpace<0, 8>] "every 8 px", 64;
        [every_1] [$crate::space::InSpace<0, 1>] "every px", 64;
        [every_fragment] [$crate::space::EveryPixel] "every fragment", 64;
    ]
}
