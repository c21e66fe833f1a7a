#pragma once

#include "engine/frame_builder.h"

#include <string>
#include <vector>

namespace engine {

inline constexpr std::size_t most_panes = 4;

/// All panes of a picture, in their order.
std::vector<Pane> panes_of(const PictureSettings& picture);

/// Where a pane lies in the picture, in pixels from its upper left corner.
struct PaneArea {
    int left = 0;
    int top = 0;
    int width = 0;
    int height = 0;
};

/// `count` panes (1 to most_panes) that fill a picture: up to three side by side, four two by two.
std::vector<PaneArea> pane_areas(std::size_t count, int width, int height);

/// The frame of a pane: the whole picture's, with the pane's size, mode and view. All panes show what the whole picture
/// shows as high, about the same middle; a narrower one shows less to the sides. It is the frame of that single
/// picture: nothing else tells them apart but whose automatic exposure is adapted.
render::RenderFrame pane_frame(render::RenderFrame whole, const Pane& pane, std::size_t index, const PaneArea& area);

/// "everything", "geometry only: D in false colour", ...
std::string pane_name(const Pane& pane);

} // namespace engine
