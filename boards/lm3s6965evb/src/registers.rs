//! The registers of the LM3S6965 that the OLED needs: system control, GPIO ports and the SSI0 port (an Arm PL022).
//!
//! This is the one place of the board that turns addresses into references; everything else is safe code. Addresses and
//! bits: TI, "Stellaris LM3S6965 Microcontroller Data Sheet", chapters 5 (system control), 8 (GPIO) and 13 (SSI).

use tock_registers::{
    register_bitfields, register_structs,
    registers::{ReadOnly, ReadWrite},
};

register_bitfields![u32,
    pub ClockGate1 [SSI0 OFFSET(4) NUMBITS(1) []],
    pub ClockGate2 [PORT_A OFFSET(0) NUMBITS(1) [], PORT_C OFFSET(2) NUMBITS(1) [], PORT_D OFFSET(3) NUMBITS(1) []],
    pub Control0 [
        /// Bits a word, less one.
        DATA_SIZE OFFSET(0) NUMBITS(4) [Byte = 7],
        FRAME_FORMAT OFFSET(4) NUMBITS(2) [Motorola = 0],
        CLOCK_POLARITY OFFSET(6) NUMBITS(1) [IdleHigh = 1],
        CLOCK_PHASE OFFSET(7) NUMBITS(1) [FirstEdge = 0],
        /// The bit rate is the system clock / (prescale * (1 + SERIAL_RATE)).
        SERIAL_RATE OFFSET(8) NUMBITS(8) []
    ],
    pub Control1 [ENABLE OFFSET(1) NUMBITS(1) [], PERIPHERAL OFFSET(2) NUMBITS(1) []],
    pub Status [
        TRANSMIT_NOT_FULL OFFSET(1) NUMBITS(1) [],
        RECEIVE_NOT_EMPTY OFFSET(2) NUMBITS(1) [],
        BUSY OFFSET(4) NUMBITS(1) []
    ],
];

register_structs! {
    /// System control: the clock gates of the peripherals.
    pub SystemControl {
        (0x000 => _reserved0),
        (0x104 => pub clock_gate1: ReadWrite<u32, ClockGate1::Register>),
        (0x108 => pub clock_gate2: ReadWrite<u32, ClockGate2::Register>),
        (0x10c => @END),
    },
    /// One GPIO port. `data[mask]` reads and writes only the pins set in `mask`, so that no pin disturbs another.
    pub Port {
        (0x000 => pub data: [ReadWrite<u32>; 256]),
        (0x400 => pub direction: ReadWrite<u32>),
        (0x404 => _reserved0),
        (0x420 => pub alternate_function: ReadWrite<u32>),
        (0x424 => _reserved1),
        (0x51c => pub digital_enable: ReadWrite<u32>),
        (0x520 => @END),
    },
    /// A synchronous serial port.
    pub Ssi {
        (0x00 => pub control0: ReadWrite<u32, Control0::Register>),
        (0x04 => pub control1: ReadWrite<u32, Control1::Register>),
        (0x08 => pub data: ReadWrite<u32>),
        (0x0c => pub status: ReadOnly<u32, Status::Register>),
        (0x10 => pub clock_prescale: ReadWrite<u32>),
        (0x14 => @END),
    }
}

/// Every peripheral the board uses, handed out once.
pub struct Peripherals {
    pub system_control: &'static SystemControl,
    pub port_a: &'static Port,
    pub port_c: &'static Port,
    pub port_d: &'static Port,
    pub ssi0: &'static Ssi,
}

impl Peripherals {
    /// The peripherals; taking `cortex_m`'s, which exist once, shows that nobody else holds these.
    pub fn new(_proof: &mut cortex_m::Peripherals) -> Self {
        // SAFETY: the data sheet puts these registers at these addresses, they exist as long as the chip does, and all
        // access goes through the volatile cells of the structures above.
        unsafe {
            Self {
                system_control: &*(0x400f_e000 as *const SystemControl),
                port_a: &*(0x4000_4000 as *const Port),
                port_c: &*(0x4000_6000 as *const Port),
                port_d: &*(0x4000_7000 as *const Port),
                ssi0: &*(0x4000_8000 as *const Ssi),
            }
        }
    }
}
