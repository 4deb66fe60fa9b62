//! DejaVu Sans Book: outlines of 23 characters, 2,048 units an em, 2,492 bytes of flash.
//!
//! Written by zrow's converter; do not edit it, but convert again:
//! ```text
//! cargo run --release -- font DejaVuSans.ttf --outlines --chars ' 0-9.:°%/\-+CFkmh'
//! ```

// Copyright, as the font says: Copyright (c) 2003 by Bitstream, Inc. All Rights Reserved. Copyright
// (c) 2006 by Tavmjong Bah. All Rights Reserved. DejaVu changes are in public domain
// Licence, as the font says: Fonts are (c) Bitstream (see below). DejaVu changes are in public
// domain. Glyphs imported from Arev fonts are (c) Tavmjung Bah (see below) Bitstream Vera Fonts
// Copyright ------------------------------ Copyright (c) 2003 by Bitstream, Inc. All Rights
// Reserved. Bitstream Vera is a trademark of Bitstream, Inc. Permission is hereby granted, free of
// charge, to any person obtaining a copy of the fonts accompanying this license ("Fonts") and
// associated documentation files (the "Font Software"), to reproduce and distribute the Font
// Software, including without limitation the rights to use, copy, merge, publish, distribute,
// and/or sell copies of the Font Software, and to permit persons to whom the Font Software is
// furnished to do so, subject to the following conditions: The above copyright and trademark
// notices and this permission notice shall be included in all copies of one or more of the Font
// Software typefaces. The Font Software may be modified, altered, or added to, and in particular
// the designs of glyphs or characters in the Fonts may be modified and additional glyphs or
// characters may be added to the Fonts, only if the fonts are renamed to names not containing
// either the words "Bitstream" or the word "Vera". This License becomes null and void to the extent
// applicable to Fonts or Font Software that has been modified and is distributed under the
// "Bitstream Vera" names. The Font Software may be sold as part of a larger software package but no
// copy of one or more of the Font Software typefaces may be sold by itself. THE FONT SOFTWARE IS
// PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO
// ANY WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT OF
// COPYRIGHT, PATENT, TRADEMARK, OR OTHER RIGHT. IN NO EVENT SHALL BITSTREAM OR THE GNOME FOUNDATION
// BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, INCLUDING ANY GENERAL, SPECIAL, INDIRECT,
// INCIDENTAL, OR CONSEQUENTIAL DAMAGES, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE,
// ARISING FROM, OUT OF THE USE OR INABILITY TO USE THE FONT SOFTWARE OR FROM OTHER DEALINGS IN THE
// FONT SOFTWARE. Except as contained in this notice, the names of Gnome, the Gnome Foundation, and
// Bitstream Inc., shall not be used in advertising or otherwise to promote the sale, use or other
// dealings in this Font Software without prior written authorization from the Gnome Foundation or
// Bitstream Inc., respectively. For further information, contact: fonts at gnome dot org. Arev
// Fonts Copyright ------------------------------ Copyright (c) 2006 by Tavmjong Bah. All Rights
// Reserved. Permission is hereby granted, free of charge, to any person obtaining a copy of the
// fonts accompanying this license ("Fonts") and associated documentation files (the "Font
// Software"), to reproduce and distribute the modifications to the Bitstream Vera Font Software,
// including without limitation the rights to use, copy, merge, publish, distribute, and/or sell
// copies of the Font Software, and to permit persons to whom the Font Software is furnished to do
// so, subject to the following conditions: The above copyright and trademark notices and this
// permission notice shall be included in all copies of one or more of the Font Software typefaces.
// The Font Software may be modified, altered, or added to, and in particular the designs of glyphs
// or characters in the Fonts may be modified and additional glyphs or characters may be added to
// the Fonts, only if the fonts are renamed to names not containing either the words "Tavmjong Bah"
// or the word "Arev". This License becomes null and void to the extent applicable to Fonts or Font
// Software that has been modified and is distributed under the "Tavmjong Bah Arev" names. The Font
// Software may be sold as part of a larger software package but no copy of one or more of the Font
// Software typefaces may be sold by itself. THE FONT SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY
// OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO ANY WARRANTIES OF MERCHANTABILITY,
// FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT OF COPYRIGHT, PATENT, TRADEMARK, OR OTHER
// RIGHT. IN NO EVENT SHALL TAVMJONG BAH BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY,
// INCLUDING ANY GENERAL, SPECIAL, INDIRECT, INCIDENTAL, OR CONSEQUENTIAL DAMAGES, WHETHER IN AN
// ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF THE USE OR INABILITY TO USE THE FONT
// SOFTWARE OR FROM OTHER DEALINGS IN THE FONT SOFTWARE. Except as contained in this notice, the
// name of Tavmjong Bah shall not be used in advertising or otherwise to promote the sale, use or
// other dealings in this Font Software without prior written authorization from Tavmjong Bah. For
// further information, contact: tavmjong @ free . fr.
// Licence at, as the font says: http://dejavu.sourceforge.net/wiki/index.php/License

use zrow::draw::{OutlineFont, OutlineGlyph};

/// DejaVu Sans in any size.
pub static DEJAVU_SANS_OUTLINES: OutlineFont = OutlineFont {
    units_per_em: 2048,
    ranges: &RANGES,
    glyphs: &GLYPHS,
    small_points: &[],
    points: &POINTS,
    flags: &FLAGS,
    crossing: &[],
    kerning: &KERNING,
    ascent: 1901,
    descent: 483,
    line_height: 2384,
    underline: (130, 90),
    strikethrough: (-530, 102),
    replacement: None,
};

#[rustfmt::skip]
static RANGES: [(char, u16, u16); 10] = [
    (' ', 1, 0),
    ('%', 1, 1),
    ('+', 1, 2),
    ('-', 14, 3),
    ('C', 1, 17),
    ('F', 1, 18),
    ('h', 1, 19),
    ('k', 1, 20),
    ('m', 1, 21),
    ('°', 1, 22),
];

#[rustfmt::skip]
static GLYPHS: [OutlineGlyph; 23] = [
    OutlineGlyph { first: 0, points: 0, advance: 651, left: 0, bottom: 0, right: 0, top: 0 }, // ' '
    OutlineGlyph { first: 0, points: 49, advance: 1946, left: 113, bottom: -29, right: 1833, top: 1520 }, // '%'
    OutlineGlyph { first: 49, points: 12, advance: 1716, left: 217, bottom: 0, right: 1499, top: 1284 }, // '+'
    OutlineGlyph { first: 61, points: 4, advance: 739, left: 100, bottom: 479, right: 639, top: 643 }, // '-'
    OutlineGlyph { first: 65, points: 4, advance: 651, left: 219, bottom: 0, right: 430, top: 254 }, // '.'
    OutlineGlyph { first: 69, points: 4, advance: 690, left: 0, bottom: -190, right: 690, top: 1493 }, // '/'
    OutlineGlyph { first: 73, points: 23, advance: 1303, left: 135, bottom: -29, right: 1167, top: 1520 }, // '0'
    OutlineGlyph { first: 96, points: 11, advance: 1303, left: 225, bottom: 0, right: 1114, top: 1493 }, // '1'
    OutlineGlyph { first: 107, points: 29, advance: 1303, left: 150, bottom: 0, right: 1098, top: 1520 }, // '2'
    OutlineGlyph { first: 136, points: 41, advance: 1303, left: 156, bottom: -29, right: 1139, top: 1520 }, // '3'
    OutlineGlyph { first: 177, points: 14, advance: 1303, left: 100, bottom: 0, right: 1188, top: 1493 }, // '4'
    OutlineGlyph { first: 191, points: 29, advance: 1303, left: 158, bottom: -29, right: 1124, top: 1493 }, // '5'
    OutlineGlyph { first: 220, points: 36, advance: 1303, left: 143, bottom: -29, right: 1174, top: 1520 }, // '6'
    OutlineGlyph { first: 256, points: 7, advance: 1303, left: 168, bottom: 0, right: 1128, top: 1493 }, // '7'
    OutlineGlyph { first: 263, points: 44, advance: 1303, left: 139, bottom: -29, right: 1163, top: 1520 }, // '8'
    OutlineGlyph { first: 307, points: 36, advance: 1303, left: 129, bottom: -29, right: 1159, top: 1520 }, // '9'
    OutlineGlyph { first: 343, points: 8, advance: 690, left: 240, bottom: 0, right: 451, top: 1059 }, // ':'
    OutlineGlyph { first: 351, points: 26, advance: 1430, left: 115, bottom: -29, right: 1319, top: 1520 }, // 'C'
    OutlineGlyph { first: 377, points: 10, advance: 1178, left: 201, bottom: 0, right: 1059, top: 1493 }, // 'F'
    OutlineGlyph { first: 387, points: 20, advance: 1298, left: 186, bottom: 0, right: 1124, top: 1556 }, // 'h'
    OutlineGlyph { first: 407, points: 11, advance: 1186, left: 186, bottom: 0, right: 1180, top: 1556 }, // 'k'
    OutlineGlyph { first: 418, points: 35, advance: 1995, left: 186, bottom: 0, right: 1821, top: 1147 }, // 'm'
    OutlineGlyph { first: 453, points: 25, advance: 1024, left: 195, bottom: 885, right: 829, top: 1520 }, // '°'
];

#[rustfmt::skip]
static KERNING: [(u16, u16, i16); 2] = [
    (18, 4, -329),
    (18, 16, -159),
];

#[rustfmt::skip]
static POINTS: [[i16; 2]; 478] = [
    // '%'
    [1489, 657], [1402, 657], [1303, 509], [1303, 377], [1303, 247], [1402, 98], [1489, 98],
    [1574, 98], [1673, 247], [1673, 377], [1673, 508], [1574, 657],
    [1489, 784], [1647, 784], [1833, 564], [1833, 190], [1646, -29], [1489, -29], [1329, -29],
    [1143, 190], [1143, 377], [1143, 565], [1330, 784],
    [457, 1393], [371, 1393], [272, 1244], [272, 1114], [272, 982], [370, 834], [544, 834],
    [643, 982], [643, 1114], [643, 1243], [543, 1393],
    [1360, 1520], [1520, 1520], [586, -29], [426, -29],
    [457, 1520], [615, 1520], [803, 1301], [803, 1114], [803, 925], [616, 707], [298, 707],
    [113, 926], [113, 1114], [113, 1300], [299, 1520],
    // '+'
    [942, 1284], [942, 727], [1499, 727], [1499, 557], [942, 557], [942, 0], [774, 0], [774, 557],
    [217, 557], [217, 727], [774, 727], [774, 1284],
    // '-'
    [100, 643], [639, 643], [639, 479], [100, 479],
    // '.'
    [219, 254], [430, 254], [430, 0], [219, 0],
    // '/'
    [520, 1493], [690, 1493], [170, -190], [0, -190],
    // '0'
    [651, 1360], [495, 1360], [338, 1053], [338, 745], [338, 438], [495, 131], [651, 131],
    [808, 131], [965, 438], [965, 745], [965, 1053], [808, 1360],
    [651, 1520], [902, 1520], [1167, 1123], [1167, 745], [1167, 368], [902, -29], [400, -29],
    [135, 368], [135, 745], [135, 1123], [400, 1520],
    // '1'
    [254, 170], [584, 170], [584, 1309], [225, 1237], [225, 1421], [582, 1493], [784, 1493],
    [784, 170], [1114, 170], [1114, 0], [254, 0],
    // '2'
    [393, 170], [1098, 170], [1098, 0], [150, 0], [150, 170], [265, 289], [662, 690], [713, 748],
    [810, 857], [887, 1008], [887, 1081], [887, 1200], [720, 1350], [586, 1350], [491, 1350],
    [280, 1284], [160, 1217], [160, 1421], [282, 1470], [494, 1520], [582, 1520], [814, 1520],
    [1090, 1288], [1090, 1094], [1090, 1002], [1021, 837], [930, 725], [905, 696], [637, 419],
    // '3'
    [831, 805], [976, 774], [1139, 578], [1139, 434], [1139, 213], [835, -29], [555, -29],
    [461, -29], [262, 8], [156, 45], [156, 240], [240, 191], [440, 141], [549, 141], [739, 141],
    [938, 291], [938, 434], [938, 566], [753, 715], [588, 715], [414, 715], [414, 881], [596, 881],
    [745, 881], [903, 1000], [903, 1112], [903, 1227], [740, 1350], [588, 1350], [505, 1350],
    [315, 1314], [201, 1276], [201, 1456], [316, 1488], [517, 1520], [606, 1520], [836, 1520],
    [1104, 1311], [1104, 1133], [1104, 1009], [962, 838],
    // '4'
    [774, 1317], [264, 520], [774, 520],
    [721, 1493], [975, 1493], [975, 520], [1188, 520], [1188, 352], [975, 352], [975, 0], [774, 0],
    [774, 352], [100, 352], [100, 547],
    // '5'
    [221, 1493], [1014, 1493], [1014, 1323], [406, 1323], [406, 957], [450, 972], [538, 987],
    [582, 987], [832, 987], [1124, 713], [1124, 479], [1124, 238], [824, -29], [551, -29],
    [457, -29], [262, 3], [158, 35], [158, 238], [248, 189], [440, 141], [547, 141], [720, 141],
    [922, 323], [922, 635], [720, 817], [547, 817], [466, 817], [305, 781], [221, 743],
    // '6'
    [676, 827], [540, 827], [381, 641], [381, 479], [381, 318], [540, 131], [812, 131], [971, 318],
    [971, 479], [971, 641], [812, 827],
    [1077, 1460], [1077, 1276], [1001, 1312], [846, 1350], [770, 1350], [570, 1350], [359, 1080],
    [344, 807], [403, 894], [581, 987], [688, 987], [913, 987], [1174, 714], [1174, 479],
    [1174, 249], [902, -29], [676, -29], [417, -29], [143, 368], [143, 745], [143, 1099],
    [479, 1520], [762, 1520], [838, 1520], [993, 1490],
    // '7'
    [168, 1493], [1128, 1493], [1128, 1407], [586, 0], [375, 0], [885, 1323], [168, 1323],
    // '8'
    [651, 709], [507, 709], [342, 555], [342, 285], [507, 131], [795, 131], [961, 286], [961, 420],
    [961, 555], [796, 709],
    [449, 795], [319, 827], [174, 1005], [174, 1133], [174, 1312], [429, 1520], [651, 1520],
    [874, 1520], [1128, 1312], [1128, 1133], [1128, 1005], [983, 827], [854, 795], [1000, 761],
    [1163, 563], [1163, 420], [1163, 203], [898, -29], [404, -29], [139, 203], [139, 420],
    [139, 563], [303, 761],
    [375, 1114], [375, 998], [520, 868], [651, 868], [781, 868], [928, 998], [928, 1230],
    [781, 1360], [651, 1360], [520, 1360], [375, 1230],
    // '9'
    [225, 31], [225, 215], [301, 179], [457, 141], [532, 141], [732, 141], [943, 410], [958, 684],
    [900, 598], [722, 506], [614, 506], [390, 506], [129, 777], [129, 1012], [129, 1242],
    [401, 1520], [627, 1520], [886, 1520], [1159, 1123], [1159, 745], [1159, 392], [824, -29],
    [541, -29], [465, -29], [309, 1],
    [627, 664], [763, 664], [922, 850], [922, 1012], [922, 1173], [763, 1360], [491, 1360],
    [332, 1173], [332, 1012], [332, 850], [491, 664],
    // ':'
    [240, 254], [451, 254], [451, 0], [240, 0],
    [240, 1059], [451, 1059], [451, 805], [240, 805],
    // 'C'
    [1319, 1378], [1319, 1165], [1217, 1260], [986, 1354], [856, 1354], [600, 1354], [328, 1041],
    [328, 745], [328, 450], [600, 137], [856, 137], [986, 137], [1217, 231], [1319, 326],
    [1319, 115], [1213, 43], [976, -29], [844, -29], [505, -29], [115, 386], [115, 745],
    [115, 1105], [505, 1520], [844, 1520], [978, 1520], [1215, 1449],
    // 'F'
    [201, 1493], [1059, 1493], [1059, 1323], [403, 1323], [403, 883], [995, 883], [995, 713],
    [403, 713], [403, 0], [201, 0],
    // 'h'
    [1124, 676], [1124, 0], [940, 0], [940, 670], [940, 829], [816, 987], [692, 987], [543, 987],
    [371, 797], [371, 633], [371, 0], [186, 0], [186, 1556], [371, 1556], [371, 946], [437, 1047],
    [616, 1147], [733, 1147], [926, 1147], [1124, 908],
    // 'k'
    [186, 1556], [371, 1556], [371, 637], [920, 1120], [1155, 1120], [561, 596], [1180, 0],
    [940, 0], [371, 547], [371, 0], [186, 0],
    // 'm'
    [1065, 905], [1134, 1029], [1326, 1147], [1456, 1147], [1631, 1147], [1821, 902], [1821, 676],
    [1821, 0], [1636, 0], [1636, 670], [1636, 831], [1522, 987], [1405, 987], [1262, 987],
    [1096, 797], [1096, 633], [1096, 0], [911, 0], [911, 670], [911, 832], [797, 987], [678, 987],
    [537, 987], [371, 796], [371, 633], [371, 0], [186, 0], [186, 1120], [371, 1120], [371, 946],
    [434, 1049], [610, 1147], [731, 1147], [853, 1147], [1024, 1023],
    // '°'
    [512, 1391], [432, 1391], [322, 1280], [322, 1200], [322, 1121], [432, 1012], [592, 1012],
    [702, 1121], [702, 1279], [591, 1391],
    [512, 1520], [576, 1520], [694, 1471], [737, 1425], [783, 1380], [829, 1266], [829, 1200],
    [829, 1068], [644, 885], [510, 885], [375, 885], [195, 1065], [195, 1200], [195, 1334],
    [379, 1520],
];

#[rustfmt::skip]
static FLAGS: [u8; 120] = [
    0x41, 0x10, 0x84, 0x01, 0x04, 0x61, 0x10, 0x40, 0x58, 0x1d, 0x04, 0x10, 0x56, 0x55, 0x55, 0x57,
    0x57, 0x57, 0x07, 0x41, 0x10, 0x06, 0x01, 0x84, 0x55, 0x55, 0x75, 0x55, 0x10, 0x04, 0x41, 0x41,
    0x10, 0x84, 0x41, 0x10, 0x14, 0x04, 0x41, 0x15, 0x04, 0x41, 0x41, 0x10, 0xd6, 0x55, 0x55, 0x75,
    0x55, 0x10, 0x04, 0x41, 0x41, 0x00, 0xc1, 0x41, 0x00, 0x61, 0x41, 0x10, 0x04, 0x41, 0x10, 0x84,
    0x55, 0x75, 0x00, 0x10, 0x06, 0x41, 0x10, 0x04, 0x01, 0x84, 0x41, 0x00, 0x61, 0x41, 0x10, 0x04,
    0x41, 0x10, 0x84, 0x41, 0x00, 0x61, 0x75, 0x75, 0x41, 0x10, 0x04, 0x05, 0x41, 0x10, 0x56, 0x55,
    0x75, 0x15, 0x04, 0x55, 0x05, 0x61, 0x55, 0x55, 0x1d, 0x04, 0x55, 0x10, 0x54, 0x41, 0x50, 0x55,
    0x10, 0x06, 0x01, 0x60, 0x10, 0x04, 0x41, 0x08,
];
