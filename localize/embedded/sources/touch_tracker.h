/* Touches from the decisions of touch_decoder.h: when each came down, moved, beat and ended, and where it was.
 *
 * Portable C99: no heap, no recursion, nothing but math.h. It reports what `acoustic-fem live` reports.
 *
 *     static touch_tracker tracker;
 *     touch_event events[TOUCH_EVENTS_AT_ONCE];
 *     touch_tracker_init(&tracker, TOUCH_DELAY);
 *     if (decoder.is_new) {
 *         int count = touch_tracker_take(&tracker, &decoder.decision, events);
 *         for (int k = 0; k < count; k++) act_on(&events[k]);
 *     }
 */
#ifndef TOUCH_TRACKER_H
#define TOUCH_TRACKER_H

#include <stdint.h>

#include "touch_decoder.h"
#include "touch_serial.h"
#include "touch_tracker_options.h"

#define TOUCH_EVENTS_AT_ONCE 12 /* more than one decision can cause */

#ifdef __cplusplus
extern "C" {
#endif

typedef struct {
    uint32_t sample;                      /* up to the end of the frame */
    float level;                          /* Pa rms */
    int point;                            /* from 0 */
    float log_probability[TOUCH_POINTS];  /* of every point, nats */
} touch_observation;

typedef struct {
    float sum[TOUCH_POINTS];              /* of the log-probabilities times levels */
    float of_loudest[TOUCH_POINTS];       /* log-probabilities of the loudest frame */
    float levels, loudest;
} touch_evidence;

/* Wave of the pressure since a touch, or a beat of it, began. */
typedef struct {
    int is_known;
    float foot, peak;                     /* Pa, the peak above the foot */
    uint32_t rests, fallen;               /* decisions near the foot; decisions since it has fallen back, or 0 */
} touch_wave;

/* The last touch, to which contacts may belong. */
typedef struct {
    int is_there, has_ended, is_first_contact, was_quiet;
    int goes_up;                          /* whether it began with a rise of the pressure */
    int is_round;                         /* whether it began as a beat does; -1 before that is known */
    uint32_t begin, beat, last;           /* samples: its begin, that of its last beat, and when it was there last */
    float level;                          /* the largest, Pa rms */
    touch_wave wave;
} touch_held;

typedef struct {
    float delay;                          /* s, that latencies are longer by */
    uint32_t sample;                      /* of the newest decision */
    int has_sample;
    /* Contacts: frames that follow each other. */
    uint32_t last_touched;
    int has_touched, length;
    float loudest, least;
    int in_contact;
    uint32_t hops;                        /* since the contact began */
    /* Mean pressures of the last decisions, a ring. */
    float course[TOUCH_TRACKER_REMEMBERED];
    int newest, known;
    /* Frames of a contact of which it is not known yet what it is. */
    touch_observation pending[TOUCH_TRACKER_WAIT];
    int waiting;
    touch_held touch;
    /* Where the touch is. */
    uint32_t number;                      /* of the last touch that came down */
    int point;                            /* that is reported, from 0; -1 before that */
    uint32_t first;                       /* sample of its first frame */
    int count;                            /* frames of its contact */
    float touch_loudest, touch_level;     /* of all its frames, and of the newest */
    int named[TOUCH_TRACKER_AGREE];       /* points of the newest frames */
    float belief[TOUCH_POINTS];
    int has_belief;
    touch_evidence evidence;              /* of all its frames */
    touch_evidence elsewhere;             /* of the newest frames that name another point */
    int other;                            /* how many these are */
    uint32_t other_first;
    touch_event *events;                  /* where the next one goes */
    int told;
} touch_tracker;

/* Forget everything. delay: s, of the samples before they reach the decoder, and of its high-pass, TOUCH_DELAY. */
void touch_tracker_init(touch_tracker *tracker, float delay);

/* Take the next decision; writes what follows from it, at most TOUCH_EVENTS_AT_ONCE events, and returns how many. */
int touch_tracker_take(touch_tracker *tracker, const touch_decision *decision, touch_event *events);

#ifdef __cplusplus
}
#endif

#endif
