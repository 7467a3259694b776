#include "reference/render/trace/row_table.h"

namespace reference::render {

template RenderRow row_renderer_over<ListOfObjects<false>>(const Effects& effects);

}  // namespace reference::render
