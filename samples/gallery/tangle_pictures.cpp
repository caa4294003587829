// SPDX-License-Identifier: MIT
// Tangles: operators, seeds, grouping, scaffolds, perturbation, displacement and macros, after Fig. 5 and 7 to 13 of
// Nazzaro, Puppo, Pellacini: geoTangle (2021).
#include <cmath>
#include <deque>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/ornament.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

// Enamel.
constexpr render::Material kIvory = {{0.66f, 0.62f, 0.54f}, 0.0f, 0.35f},
                           kPetrol = {{0.006f, 0.085f, 0.100f}, 0.0f, 0.28f},
                           kAmber = {{0.62f, 0.22f, 0.020f}, 0.0f, 0.32f},
                           kPlum = {{0.110f, 0.012f, 0.045f}, 0.0f, 0.30f};

Panel panel_with(const Moment& moment, const glm::vec3& sight) {
    Panel panel;
    panel.surfaces = {moment.layer()};
    panel.sight = sight;
    panel.margin = 1.07f;
    return panel;
}

// A picture of moments, which are kept until it is taken.
class Sequence {
public:
    explicit Sequence(const glm::vec3& sight) : sight_(sight) {}

    void add(Moment moment) { panels_.push_back(panel_with(moments_.emplace_back(std::move(moment)), sight_)); }
    void take(Studio& studio, const char* name, uint32_t columns, uint32_t width, uint32_t height,
              std::initializer_list<const char*> titles) {
        entitle(panels_, titles);
        studio.take(name, panels_, columns, width, height);
    }

private:
    glm::vec3 sight_;
    std::deque<Moment> moments_;
    std::vector<Panel> panels_;
};

void paint_by_turns(Ornament& ornament, const Regions& made, const render::Material& even,
                    const render::Material& odd) {
    ornament.paint(ornament.even(made), even);
    ornament.paint(ornament.odd(made), odd);
}

// ---- Fig. 5

constexpr glm::vec3 kFromTop = {-0.05f, -1.0f, -0.35f};

// Dark where the sum of the parts of a region and of that around it is odd.
void chequer(Ornament& ornament, const Regions& made, const render::Material& even, const render::Material& odd) {
    for (const uint32_t region : made) {
        const FlgTangleRegion node = ornament.tangle().region(region);
        const bool is_even = (node.part + ornament.tangle().region(node.parent).part) % 2 == 0;
        ornament.paint({region}, is_even ? even : odd);
    }
}

void patterns(Workshop& workshop, Studio& studio) {
    // A cloth's outline begins in a corner; its sides are quarters.
    const Seeds left = Seeds::loop(0, 0.75f, 1.0f), near = Seeds::loop(0, 0.0f, 0.25f);
    Sequence sequence(kFromTop);
    const auto add = [&](const render::Material& odd, auto&& draw) {
        Ornament ornament(workshop, cloth(workshop), kCream);
        draw(ornament, odd);
        sequence.add(ornament.moment(kBorder));
    };
    add(kCobalt, [](Ornament& ornament, const render::Material& odd) {
        paint_by_turns(ornament, ornament.divide(contour(0.05f, 9), Ornament::root(), Seeds::outline()), odd, kCream);
    });
    add(kRust, [&](Ornament& ornament, const render::Material& odd) {
        paint_by_turns(ornament, ornament.divide(contour(0.0625f, 0), Ornament::root(), left), kCream, odd);
    });
    add(kSage, [&](Ornament& ornament, const render::Material& odd) {
        ornament.divide(contour(0.125f, 0), Ornament::root(), left);
        chequer(ornament, ornament.divide(contour(0.125f, 0), Ornament::root(), near), kCream, odd);
    });
    add(kPlum, [](Ornament& ornament, const render::Material& odd) {
        paint_by_turns(ornament, ornament.divide(contour(0.042f), Ornament::root(), Seeds::sampled(0.115f)), odd,
                       kCream);
    });
    add(kPetrol, [](Ornament& ornament, const render::Material& odd) {
        const Regions cells = ornament.divide(voronoi(), Ornament::root(), Seeds::sampled(0.15f));
        constexpr render::Material kColors[] = {kIvory, kCream, kSage};
        for (size_t i = 0; i < cells.size(); ++i) ornament.paint({cells[i]}, i % 4 == 3 ? odd : kColors[i % 4]);
    });
    add(kAmber, [](Ornament& ornament, const render::Material& odd) {
        const Seeds middle = Seeds::at({ornament.near({0.5f, 0.0f, 0.5f})});
        const Regions around = ornament.divide(contour(0.09f), Ornament::root(), middle);
        ornament.paint(ornament.even(around), kPlum);
        // Loop 0 is the outline of the cloth, 1 that of the disc in its middle.
        const Regions rays = ornament.divide(stream(0.0236f), ornament.odd(around), Seeds::loop(1));
        paint_by_turns(ornament, rays, odd, kCream);
    });
    sequence.take(studio, "tangle_patterns", 6, 1440, 250,
                  {"Outline", "Hatch", "Grid", "Polka dots", "Voronoi", "Radial"});
}

// ---- Fig. 7

constexpr glm::vec3 kFromAbove = {-0.30f, -0.85f, -1.0f};
constexpr uint32_t kOuter = 0, kInner = 1;  // loops of the dish

// One operator on a dish.
Moment on_dish(Workshop& workshop, const FlgTangleDivideDesc& desc, const Seeds& a, const Seeds& b,
               const render::Material& even, const render::Material& odd) {
    Ornament ornament(workshop, dish(workshop), odd);
    paint_by_turns(ornament, ornament.divide(desc, Ornament::root(), a, b), even, odd);
    return ornament.moment(kBorder);
}

// Cells in four colours.
Moment cells_on_dish(Workshop& workshop, const Seeds& seeds) {
    Ornament ornament(workshop, dish(workshop), kIvory);
    const Regions cells = ornament.divide(voronoi(), Ornament::root(), seeds);
    constexpr render::Material kColors[] = {kIvory, kPetrol, kAmber, kPlum};
    for (size_t i = 0; i < cells.size(); ++i) ornament.paint({cells[i]}, kColors[i % std::size(kColors)]);
    return ornament.moment(kBorder);
}

void operators(Workshop& workshop, Studio& studio) {
    const Seeds inner = Seeds::loop(kInner), outer = Seeds::loop(kOuter);
    const Ornament plain(workshop, dish(workshop), kCream);
    const auto on_rim = [&](float x, float y, float z) { return plain.near({x, y, z}); };
    Sequence sequence(kFromAbove);
    sequence.add(on_dish(workshop, contour(0.12f), inner, {}, kCream, kCobalt));
    sequence.add(on_dish(workshop, contour(0.045f, 4), inner, {}, kCream, kCobalt));
    sequence.add(on_dish(workshop, contour(0.1f, 0), inner, outer, kCream, kCobalt));
    sequence.add(on_dish(workshop, contour(0.033f), Seeds::sampled(0.1f), {}, kCream, kCobalt));
    // A cloth's outline begins in a corner; its sides are quarters.
    const Seeds left = Seeds::loop(0, 0.75f, 1.0f), right = Seeds::loop(0, 0.25f, 0.5f),
                near = Seeds::loop(0, 0.0f, 0.25f), far = Seeds::loop(0, 0.5f, 0.75f);
    Ornament chequered(workshop, cloth(workshop), kCream);
    const Regions stripes = chequered.divide(contour(0.125f, 0), Ornament::root(), left, right);
    paint_by_turns(chequered, stripes, kCream, kCobalt);
    sequence.add(chequered.moment(kBorder));
    chequer(chequered, chequered.divide(contour(0.125f, 0), Ornament::root(), near, far), kCream, kCobalt);
    sequence.add(chequered.moment(kBorder));
    sequence.add(on_dish(workshop, stream(0.0346f), inner, {}, kIvory, kPetrol));
    sequence.add(on_dish(workshop, stream(0.0346f), inner, outer, kIvory, kPetrol));
    sequence.add(cells_on_dish(workshop, Seeds::sampled(0.12f)));
    std::vector<FlgSurfacePoint> picked;
    for (int i = 0; i < 7; ++i) {
        const float angle = 0.9f * static_cast<float>(i);
        picked.push_back(on_rim(0.34f * std::cos(angle), 0.22f, 0.34f * std::sin(angle)));
    }
    sequence.add(cells_on_dish(workshop, Seeds::at(picked)));
    std::vector<FlgSurfacePoint> around;
    for (int i = 0; i < 10; ++i) {
        const float angle = 0.6283f * static_cast<float>(i), radius = i % 2 == 0 ? 0.40f : 0.22f;
        around.push_back(on_rim(radius * std::cos(angle), 0.2f, radius * std::sin(angle)));
    }
    sequence.add(on_dish(workshop, polyline(true), Seeds::at(around), {}, kAmber, kPlum));
    const std::vector<FlgSurfacePoint> across = {on_rim(-0.5f, 0.0f, 0.0f), on_rim(-0.2f, 0.23f, 0.2f),
                                                 on_rim(0.25f, 0.22f, 0.22f), on_rim(0.46f, 0.0f, -0.2f)};
    sequence.add(on_dish(workshop, polyline(false), Seeds::at(across), {}, kAmber, kPlum));
    sequence.take(studio, "tangle_operators", 4, 1280, 720,
                  {"Contour: once from the hole", "Four times from the hole", "From hole to rim", "Around samples",
                   "From side to side", "and across", "Stream from the hole", "Stream, hole to rim", "Cells of samples",
                   "Cells of picked points", "Polyline: closed", "Polyline: rim to rim"});
}

// ---- Fig. 8

constexpr glm::vec3 kFromTheSide = {-0.25f, -0.50f, -1.0f};
constexpr uint32_t kFoot = 0, kLip = 1;  // loops of the vase

Regions banded(Ornament& ornament) {
    const Regions bands =
        ornament.divide(contour(1.0f / 9.0f, 0), Ornament::root(), Seeds::loop(kFoot), Seeds::loop(kLip));
    paint_by_turns(ornament, bands, kRust, kCream);
    return bands;
}

void grouping(Workshop& workshop, Studio& studio) {
    Ornament by_itself(workshop, vase(workshop), kCream), together(workshop, vase(workshop), kCream);
    Sequence sequence(kFromTheSide);
    const Regions bands = banded(by_itself);
    sequence.add(by_itself.moment(kBorder));
    const FlgTangleDivideDesc spots = contour(0.022f);
    const Seeds samples = Seeds::sampled(0.065f);
    by_itself.paint(by_itself.even(by_itself.divide_each(spots, by_itself.odd(bands), samples)), kCobalt);
    sequence.add(by_itself.moment(kBorder));
    banded(together);
    const Regions dots = together.divide(spots, Ornament::root(), samples);
    for (const uint32_t dot : together.even(dots)) {
        const bool on_rust = together.tangle().region(together.tangle().region(dot).parent).part % 2 == 0;
        together.paint({dot}, on_rust ? kCream : kCobalt);
    }
    sequence.add(together.moment(kBorder));
    sequence.take(studio, "tangle_grouping", 3, 1080, 480,
                  {"Stripes", "Dots in each light stripe", "Dots on all together"});
}

// ---- Fig. 9

void scaffold(Workshop& workshop, Studio& studio) {
    Ornament ornament(workshop, vase(workshop), kIvory);
    FlgTangleDivideDesc bands = contour(1.0f / 9.0f, 0), strips = stream(0.089f);
    bands.scaffold = strips.scaffold = 1;
    ornament.divide(bands, Ornament::root(), Seeds::loop(kFoot), Seeds::loop(kLip));
    const Regions cells = ornament.divide(strips, Ornament::root(), Seeds::loop(kFoot), Seeds::loop(kLip));
    Regions dark;
    for (const uint32_t cell : cells) {
        const FlgTangleRegion node = ornament.tangle().region(cell);
        if ((node.part + ornament.tangle().region(node.parent).part) % 2 == 0) dark.push_back(cell);
    }
    ornament.paint(dark, kSage);
    Sequence sequence(kFromTheSide);
    sequence.add(ornament.moment(kBorder, true));
    Seeds seeds = Seeds::sampled(0.05f);
    seeds.of = dark;
    const Regions dots = ornament.divide(contour(0.018f), Ornament::root(), seeds);
    ornament.paint(ornament.even(dots), kPlum);
    sequence.add(ornament.moment(kBorder, true));
    sequence.add(ornament.moment(kBorder));
    sequence.take(studio, "tangle_scaffold", 3, 1080, 480,
                  {"A grid as a scaffold", "Dots in its dark cells", "The scaffold is not seen"});
}

// ---- Fig. 10

void perturbation(Workshop& workshop, Studio& studio) {
    Sequence sequence(kFromTheSide);
    for (const float amount : {0.0f, 0.03f, 0.08f}) {
        Ornament ornament(workshop, vase(workshop), kCream);
        FlgTangleDivideDesc bands = contour(1.0f / 7.0f, 0), dots = contour(0.034f);
        bands.perturbation = dots.perturbation = amount;
        bands.frequency = dots.frequency = 9.0f;
        const Regions made = ornament.divide(bands, Ornament::root(), Seeds::loop(kFoot), Seeds::loop(kLip));
        paint_by_turns(ornament, made, kCobalt, kCream);
        const Regions spots = ornament.divide_each(dots, ornament.odd(made), Seeds::sampled(0.09f));
        ornament.paint(ornament.even(spots), kRust);
        sequence.add(ornament.moment(kBorder));
    }
    sequence.take(studio, "tangle_perturbation", 3, 1080, 480, {"No noise", "Noise of 3 cm", "Noise of 8 cm"});
}

// ---- Fig. 11

FlgTangleDisplaceDesc rise(float amount, float bias) {
    FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
    desc.amount = amount;
    desc.bias = bias;
    return desc;
}

Moment displaced(Workshop& workshop, float amount, float bias, float gain) {
    Ornament ornament(workshop, ball(workshop), kIvory);
    const Regions made = ornament.divide(contour(0.115f), Ornament::root(), Seeds::sampled(0.26f));
    const Regions spots = ornament.even(made);
    ornament.paint(spots, kAmber);
    FlgTangleDisplaceDesc desc = rise(amount, bias);
    desc.gain = gain;
    ornament.displace(desc, spots);
    // Rings by the distance on what has risen.
    const Regions rings = ornament.divide(contour(0.03f, 0), spots, Seeds::outline());
    paint_by_turns(ornament, rings, kPlum, kAmber);
    return ornament.moment();
}

void displacement(Workshop& workshop, Studio& studio) {
    Sequence sequence(kFromTheSide);
    sequence.add(displaced(workshop, 0.12f, 0.5f, 0.5f));
    sequence.add(displaced(workshop, 0.09f, 0.85f, 0.5f));
    sequence.add(displaced(workshop, 0.24f, 0.22f, 0.5f));
    sequence.add(displaced(workshop, 0.12f, 0.5f, 0.12f));
    sequence.take(studio, "tangle_displacement", 4, 1280, 340, {"Straight", "Bias 0.85", "Bias 0.22", "Gain 0.12"});
}

// ---- Fig. 12

// Stripes and grids as structures for more.
Moment structured(Workshop& workshop) {
    Ornament ornament(workshop, vase(workshop), kCream);
    const Seeds foot = Seeds::loop(kFoot), lip = Seeds::loop(kLip);
    const Regions bands = ornament.divide(contour(1.0f / 9.0f, 0), Ornament::root(), foot, lip);
    Regions wide;
    for (const uint32_t band : ornament.even(bands)) {
        const Regions rims = ornament.divide(contour(0.012f), {band}, Seeds::outline());
        ornament.paint(ornament.even(rims), kCobalt);
        const Regions inside = ornament.odd(rims);
        ornament.paint(inside, kSage);
        wide.insert(wide.end(), inside.begin(), inside.end());
    }
    const Regions dots = ornament.divide_each(contour(0.026f), wide, Seeds::sampled(0.075f));
    const Regions discs = ornament.even(dots);
    ornament.displace(rise(0.012f, 0.75f), discs);
    paint_by_turns(ornament, ornament.divide(contour(0.008f, 0), discs, Seeds::outline()), kRust, kCream);
    const Regions odd = ornament.odd(bands);
    ornament.divide_each(contour(0.5f), odd, Seeds::loop(0), Seeds::loop(1));
    Regions squares;
    for (const uint32_t band : odd) {
        const Regions some = ornament.divide(stream(0.055f), {band}, Seeds::loop(0), Seeds::loop(1));
        squares.insert(squares.end(), some.begin(), some.end());
    }
    Regions dark;
    for (const uint32_t square : squares) {
        const FlgTangleRegion node = ornament.tangle().region(square);
        if ((node.part + ornament.tangle().region(node.parent).part) % 2 == 1) dark.push_back(square);
    }
    ornament.paint(dark, kCobalt);
    const Regions tiles = ornament.divide_each(contour(0.012f), dark, Seeds::outline());
    ornament.paint(ornament.odd(tiles), kCream);
    return ornament.moment(kBorder);
}

// Outline, cells, outline, displacement.
Moment crusted(Workshop& workshop) {
    Ornament ornament(workshop, dish(workshop), kIvory);
    const Regions two = ornament.divide(contour(0.085f), Ornament::root(), Seeds::outline());
    const Regions small = ornament.divide_each(voronoi(), ornament.even(two), Seeds::sampled(0.042f));
    const Regions large = ornament.divide_each(voronoi(), ornament.odd(two), Seeds::sampled(0.09f));
    const Seeds borders = {.borders = FLG_TANGLE_BORDERS_EACH};
    const Regions small_framed = ornament.divide(contour(0.005f), small, borders);
    const Regions large_framed = ornament.divide(contour(0.007f), large, borders);
    const Regions pebbles = ornament.odd(small_framed), stones = ornament.odd(large_framed);
    ornament.displace(rise(0.016f, 0.75f), pebbles);
    ornament.displace(rise(0.030f, 0.75f), stones);
    ornament.paint(pebbles, kPetrol);
    ornament.paint(stones, kAmber);
    return ornament.moment();
}

// Many regions, each in the colour of its group: even or odd.
Moment by_parity(Workshop& workshop) {
    Ornament ornament(workshop, ball(workshop), kIvory);
    const Regions cells = ornament.divide(voronoi(), Ornament::root(), Seeds::sampled(0.3f));
    Regions rings;
    for (const uint32_t cell : cells) {
        const FlgTangleDivideDesc bands = contour(0.026f, 0);
        const Regions some = ornament.divide(bands, {cell}, Seeds::outline());
        rings.insert(rings.end(), some.begin(), some.end());
    }
    // Across the rings, all at once.
    const Regions squares = ornament.divide(contour(0.055f, 0), Ornament::root(), Seeds::sampled(0.4f));
    for (const uint32_t square : squares) {
        const bool is_even = ornament.tangle().region(square).group % 2 == 0;
        ornament.paint({square}, is_even ? kIvory : kPlum);
    }
    return ornament.moment(kBorder);
}

void recursion(Workshop& workshop, Studio& studio) {
    std::deque<Moment> moments;
    moments.push_back(structured(workshop));
    moments.push_back(crusted(workshop));
    moments.push_back(by_parity(workshop));
    std::vector<Panel> panels = {panel_with(moments[0], kFromTheSide), panel_with(moments[1], kFromAbove),
                                 panel_with(moments[2], kFromTheSide)};
    entitle(panels,
            {"Stripes and a grid carry dots and frames", "Cells, raised", "Regions in the colour of their group"});
    studio.take("tangle_recursion", panels, 3, 1260, 480);
}

// ---- Fig. 13

void sunburst_to_flower(Workshop& workshop, Sequence& sequence) {
    Ornament ornament(workshop, dish(workshop), kCream);
    const Regions wedges = ornament.divide(stream(0.0576f), Ornament::root(), Seeds::loop(kInner), Seeds::loop(kOuter));
    const Regions light = ornament.even(wedges), blue = ornament.odd(wedges);
    paint_by_turns(ornament, wedges, kCream, kCobalt);
    sequence.add(ornament.moment(kBorder));
    const Regions dots = ornament.divide_each(contour(0.011f), blue, Seeds::sampled(0.034f));
    ornament.paint(ornament.even(dots), kCream);
    sequence.add(ornament.moment(kBorder));
    // The outermost frame first, each within the one before.
    Regions inside = light;
    for (int i = 0; i < 2; ++i) {
        const Regions frames = ornament.divide_each(contour(0.012f), inside, Seeds::outline());
        ornament.paint(ornament.even(frames), i == 0 ? kCream : kRust);
        inside = ornament.odd(frames);
        ornament.paint(inside, kCream);
    }
    sequence.add(ornament.moment(kBorder));
    const Regions petals = ornament.divide_each(contour(0.33f, 2), inside, Seeds::outline(), Seeds::sampled(0.085f));
    ornament.paint(ornament.part(petals, 1), kSage);
    ornament.paint(ornament.part(petals, 2), kCobalt);
    sequence.add(ornament.moment(kBorder));
}

void grid_to_cells(Workshop& workshop, Sequence& sequence) {
    Ornament ornament(workshop, dish(workshop), kIvory);
    ornament.divide(contour(0.25f, 0), Ornament::root(), Seeds::loop(kInner), Seeds::loop(kOuter));
    const Regions grid = ornament.divide(stream(0.0576f), Ornament::root(), Seeds::loop(kInner), Seeds::loop(kOuter));
    Regions light, dark;
    for (const uint32_t square : grid) {
        const FlgTangleRegion node = ornament.tangle().region(square);
        ((node.part + ornament.tangle().region(node.parent).part) % 2 == 0 ? light : dark).push_back(square);
    }
    ornament.paint(dark, kPetrol);
    sequence.add(ornament.moment(kBorder));
    const Regions light_outlines = ornament.divide_each(contour(0.009f), light, Seeds::outline());
    const Regions dark_outlines = ornament.divide_each(contour(0.009f), dark, Seeds::outline());
    ornament.paint(ornament.even(light_outlines), kAmber);
    ornament.paint(ornament.even(dark_outlines), kAmber);
    sequence.add(ornament.moment(kBorder));
    const Regions lace =
        ornament.divide_each(contour(0.013f, 2), ornament.odd(light_outlines), Seeds::along_borders(0.03f));
    ornament.paint(ornament.part(lace, 0), kPlum);
    ornament.paint(ornament.part(lace, 1), kAmber);
    sequence.add(ornament.moment(kBorder));
    const Regions cells = ornament.divide_each(voronoi(), ornament.odd(dark_outlines), Seeds::sampled(0.035f));
    constexpr render::Material kBlues[] = {
        kPetrol, {{0.020f, 0.17f, 0.18f}, 0.0f, 0.3f}, {{0.07f, 0.29f, 0.28f}, 0.0f, 0.3f}};
    for (size_t i = 0; i < cells.size(); ++i) ornament.paint({cells[i]}, kBlues[i % std::size(kBlues)]);
    sequence.add(ornament.moment(kBorder));
}

void macros(Workshop& workshop, Studio& studio) {
    Sequence sequence(kFromAbove);
    sunburst_to_flower(workshop, sequence);
    grid_to_cells(workshop, sequence);
    sequence.take(studio, "tangle_macros", 4, 1600, 760,
                  {"Sunburst", "Polka dots", "Frames", "Flower", "Grid", "Outline", "Lace", "Cells"});
}

constexpr Picture kPictures[] = {
    {"tangle_patterns", "Outline, hatch, grid, polka dots, Voronoi, radial", true, patterns},
    {"tangle_operators", "All four operators of tangles, from different seeds", true, operators},
    {"tangle_grouping", "Stripes, dots in each of them, and dots on all of them together", true, grouping},
    {"tangle_scaffold", "A grid that places dots and is not seen", true, scaffold},
    {"tangle_perturbation", "The same ornament with more and more noise on the metric", true, perturbation},
    {"tangle_displacement", "What bias and gain make of displaced dots", true, displacement},
    {"tangle_recursion", "Patterns that others are made on: stripes and grids, outlines of cells, groups by parity",
     true, recursion},
    {"tangle_macros", "Eight combinations of operators, one after the other", true, macros},
};

}  // namespace

std::span<const Picture> tangle_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
