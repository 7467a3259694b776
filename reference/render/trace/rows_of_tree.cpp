#include "reference/render/trace/row_table.h"

namespace reference::render {

template RenderRow row_renderer_over<ObjectTree>(const Effects& effects);

}  // namespace reference::render
