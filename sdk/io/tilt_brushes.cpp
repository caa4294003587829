// SPDX-License-Identifier: MIT
// Source: the program's brush manifest (googlevr/tilt-brush c5fb8671, Apache-2.0), for the brushes met in real sketches.
#include "io/tilt_brushes.h"

namespace flg::io {

namespace {

struct Brush {
    std::string_view guid;
    std::string_view name;
};

constexpr Brush brushes[] = {
    {"0077f88c-d93a-42f3-b59b-b31c50cdb414", "Taffy"},
    {"02ffb866-7fb2-4d15-b761-1012cefb1360", "Embers"},
    {"0d3889f3-3ede-470c-8af4-de4813306126", "DoubleTaperedMarker"},
    {"0d3889f3-3ede-470c-8af4-f44813306126", "DoubleTaperedFlat"},
    {"0eb4db27-3f82-408d-b5a1-19ebd7d5b711", "Stars"},
    {"0f0ff7b2-a677-45eb-a7d6-0cd7206f4816", "ChromaticWave"},
    {"10201aa3-ebc2-42d8-84b7-2e63f6eeb8ab", "Waveform"},
    {"2241cd32-8ba2-48a5-9ee7-2caef7e9ed62", "Light"},
    {"280c0a7a-aad8-416c-a7d2-df63d129ca70", "Flat"},
    {"2f212815-f4d3-c1a4-681a-feeaf9c6dc37", "Icing"},
    {"3ca16e2f-bdcd-4da2-8631-dcef342f40f1", "DuctTape"},
    {"429ed64a-4e97-4466-84d3-145a861ef684", "Marker"},
    {"4391385a-cf83-4396-9e33-31e4e4930b27", "Wire"},
    {"4391385a-df73-4396-9e33-31e4e4930b27", "Toon"},
    {"4391aaaa-df73-4396-9e33-31e4e4930b27", "Disco"},
    {"4391aaaa-df81-4396-9e33-31e4e4930b27", "LightWire"},
    {"44bb800a-fbc3-4592-8426-94ecb05ddec3", "Streamers"},
    {"55303bc4-c749-4a72-98d9-d23e68e76e18", "FlatDeprecated"},
    {"6a1cf9f9-032c-45ec-9b1d-a6680bee30f7", "Dots"},
    {"6a1cf9f9-032c-45ec-9b6e-a6680bee32e9", "HyperGrid"},
    {"700f3aa8-9a7c-2384-8b8a-ea028905dd8c", "CelVinyl"},
    {"70d79cca-b159-4f35-990c-f02193947fe8", "Smoke"},
    {"759f1ebd-20cd-4720-8d41-234e0da63716", "Paper"},
    {"79168f10-6961-464a-8be1-57ed364c5600", "CoarseBristles"},
    {"7a1c8107-50c5-4b70-9a39-421576d6617e", "Splatter"},
    {"89d104cd-d012-426b-b5b3-bbaee63ac43c", "Bubbles"},
    {"accb32f5-4509-454f-93f8-1df3fd31df1b", "SoftHighlighter"},
    {"ad1ad437-76e2-450d-a23a-e17f8310b960", "Rainbow"},
    {"b2ffef01-eaaa-4ab5-aa64-95a2c4f5dbc6", "NeonPulse"},
    {"c0012095-3ffd-4040-8ee1-fc180d346eaa", "Ink"},
    {"c33714d1-b2f9-412e-bd50-1884c9d46336", "Plasma"},
    {"c515dad7-4393-4681-81ad-162ef052241b", "OilPaint"},
    {"c8ccb53d-ae13-45ef-8afb-b730d81394eb", "TaperedFlat"},
    {"cb92b597-94ca-4255-b017-0e3f42f12f9e", "Fire"},
    {"cf019139-d41c-4eb0-a1d0-5cf54b0a42f3", "Highlighter"},
    {"d229d335-c334-495a-a801-660ac8a87360", "VelvetInk"},
    {"d902ed8b-d0d1-476c-a8de-878a79e3a34c", "Snow"},
    {"d90c6ad8-af0f-4b54-b422-e0f92abe1b3c", "TaperedMarker"},
    {"e8ef32b1-baa8-460a-9c2c-9cf8506794f5", "Hypercolor"},
    {"ea19de07-d0c0-4484-9198-18489a3c1487", "Leaves"},
    {"f6e85de3-6dcc-4e7f-87fd-cee8c3d25d51", "Electricity"},
    {"fdf0326a-c0d1-4fed-b101-9db0ff6d071f", "ThickPaint"},
};

}  // namespace

std::string_view tilt_brush_name(std::string_view guid) {
    for (const Brush& brush : brushes) {
        if (brush.guid == guid) return brush.name;
    }
    return {};
}

}  // namespace flg::io
