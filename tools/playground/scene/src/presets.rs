//! States to begin with.

/// A state with a name.
#[derive(Debug, Clone, Copy)]
pub struct Preset {
    /// As on the page.
    pub title: &'static str,
    /// The state, as in the address of the page.
    pub address: &'static str,
    /// What `measure` calls the counts of its items, in their order.
    pub counts: &'static [&'static str],
}

/// The heights of bands that `measure` counts, in rows; 0 stands for all rows. Its variants are called `NAME.ROWS`, by the name of
/// the method or the look.
pub const COUNTED_ROWS: &[u32] = &[1, 16, 0];
/// What `measure` calls the counts of a frame without a teapot and items.
pub const EMPTY_COUNT: &str = "playground.empty";
/// What `measure` calls the counts of a teapot without items, of which the look is a variant.
pub const POT_COUNT: &str = "playground.pot";

/// States to begin with; the page opens with the first one.
pub const PRESETS: &[Preset] = &[
    Preset {
        title: "Shapes",
        address: "pot=none&turn=496&tilt=504&method=exact&precision=sub8&rows=1&depth=rgb565\
            &item=circle,24506e,0,120:118;120:28.5\
            &item=polygon,f2b134,0,120:40;163.25:172.5;50.5:90.25;189.5:90.25;76.75:172.5\
            &item=line,e4572e,7,24.5:298.25;146.25:265.75\
            &item=even_odd,76b041,0,188.5:247.25;207.25:305.25;158:269.25;219:269.25;169.75:305.25\
            &item=text,f4f4ec,34,22:246,42%20km%2Fh&selected=1&point=0",
        counts: &[
            "playground.disc",
            "playground.inner_star",
            "playground.line",
            "playground.even_odd_star",
            "playground.label",
        ],
    },
    Preset {
        title: "Star, crossing itself",
        address: "pot=none&turn=496&tilt=504&method=exact&precision=sub8&rows=1&depth=rgb565\
            &item=polygon,f2b134,0,120:40;181.5:250.5;20.25:118.75;219.75:118.75;58.5:250.5&selected=0&point=0&loupe=87:111",
        counts: &["playground.star"],
    },
    Preset {
        title: "Gauge",
        address: "pot=none&turn=496&tilt=504&method=exact&precision=sub8&rows=1&depth=rgb565\
            &item=circle,2b3a4a,0,120:160;120:59.5\
            &item=circle,131c26,0,120:160;120:70.5\
            &item=line,e4572e,5,120:160;190.5:95.25\
            &item=circle,f4f4ec,0,120:160;120:152.5\
            &item=text,f4f4ec,26,76:222,42%20km%2Fh&selected=2&point=1",
        counts: &[
            "playground.rim",
            "playground.dial",
            "playground.needle",
            "playground.hub",
            "playground.reading",
        ],
    },
    Preset {
        title: "Teapot under a label",
        address: "pot=textured&turn=496&tilt=504&method=exact&precision=sub8&rows=1&depth=rgb565\
            &item=polygon,24506e,0,0:276;240:276;240:320;0:320\
            &item=text,f4f4ec,24,16:306,1%20row%20of%20depths&selected=1&point=0",
        counts: &["playground.bar", "playground.caption"],
    },
];
