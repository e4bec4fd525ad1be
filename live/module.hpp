#pragma once

/* The stage for callers that speak C: what a page calls of the WebAssembly module. Texts are UTF-8;
   a text that is given back holds until the next call. */

#ifdef __cplusplus
extern "C" {
#endif

/* A scene on its stage. */
typedef struct lodlab_live lodlab_live;

/* From the text of a scene (live/scene.hpp). Null where it is refused: lodlab_live_error says why.
 */
lodlab_live* lodlab_live_open(const char* scene);
/* The same from outlines that a reader drew (live/outline.hpp). */
lodlab_live* lodlab_live_draw(const char* outlines);
void lodlab_live_close(lodlab_live* live);
/* Why the last call failed; empty where none did. */
const char* lodlab_live_error(void);

/* The figure as JSON (viz/figure/json.cpp), and the numbers (live/picture.hpp). Null on failure. */
const char* lodlab_live_figure(lodlab_live* live);
const char* lodlab_live_state(lodlab_live* live);

/* What the next frame does, event by event, as JSON (live/picture.hpp). Null on failure. */
const char* lodlab_live_events(lodlab_live* live);
/* Of which sources this is made (live/sources.hpp). */
const char* lodlab_live_sources(void);

/* These give 0, or -1 where the call is refused, which changes nothing. */
int lodlab_live_step(lodlab_live* live, int frames);
int lodlab_live_reset(lodlab_live* live);
int lodlab_live_place(lodlab_live* live, int body, double x, double y, double angle);
int lodlab_live_move(lodlab_live* live, int body, double x, double y, double spin);
int lodlab_live_fixate(lodlab_live* live, double x, double y);
/* "level", "budget" (below 0: none), "pair_cost", "restitution"; "event": the figure is that of the
 * next frame as of that event, from 0 (below 0: of the stage as it stands). */
int lodlab_live_set(lodlab_live* live, const char* what, double value);
/* What live/choices.hpp lists, by its words. */
int lodlab_live_choose(lodlab_live* live, const char* what, const char* name);

#ifdef __cplusplus
}
#endif
