#include "engine/picture_maker.h"

#include "render/offline/reference.h"

namespace engine {

render::Picture make_picture(const content::SceneDesc& scene, const PictureRequest& request) {
    return render::ReferenceRenderer(scene).render(request.frame, request.samples_per_side);
}

} // namespace engine
