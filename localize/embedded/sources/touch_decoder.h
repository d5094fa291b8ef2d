/* Where an array of acoustic tactile sensors was touched, from its microphones alone.
 *
 * Portable C99: no heap, no recursion, nothing but math.h. The tables of the array are constants in touch_tables.c.
 *
 *     static touch_decoder decoder;
 *     touch_init(&decoder, TOUCH_OVERLOAD);                   Pa, from which a sample is clipped
 *     for (;;) {
 *         size_t taken = 0, count = fill(samples);            interleaved, Pa, 1000 of each microphone in a second
 *         while (taken < count) {
 *             taken += touch_push(&decoder, samples + taken * TOUCH_MICROPHONES, count - taken);
 *             if (decoder.is_new) act_on(&decoder.decision);
 *         }
 *     }
 */
#ifndef TOUCH_DECODER_H
#define TOUCH_DECODER_H

#include <stddef.h>
#include <stdint.h>

#include "touch_tables.h"

#define TOUCH_HOP 16    /* samples from one decision to the next */
#define TOUCH_FRAME 250 /* samples that one decision is made from */
#define TOUCH_HOPS 16   /* hops that a frame lies in */

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    TOUCH_NONE,      /* nothing is louder than the silence of the microphones */
    TOUCH_FADING,    /* what is left of a touch that has ended */
    TOUCH_SOUND,     /* sound of a room, the same on all membranes, and no touch */
    TOUCH_TOUCHED,   /* a point is touched */
    TOUCH_UNREADABLE /* a microphone is clipped or dead, or there is no whole frame yet */
} touch_state;

typedef struct {
    uint32_t sample;                 /* samples up to the end of the frame, from the start; 0 again after 49 days */
    touch_state state;
    float level;                     /* of the loudest microphone about its mean, Pa rms */
    float mean;                      /* of all microphones over the last hop as they came, Pa; 0 if unreadable */
    int point;                       /* the most probable one, from 1; 0 unless a point is touched */
    float probability;               /* of that point; 0 unless a point is touched */
    int top[TOUCH_TOP];              /* the most probable points, from 1; 0 where there is none */
    float posterior[TOUCH_POINTS];   /* probability of every point; of the last touch */
} touch_decision;

typedef struct {
    float mean, square; /* of some values: mean, and sum of squares about it */
} touch_spread;

typedef struct {
    touch_decision decision;
    int is_new;                      /* whether the last push ended with a new decision */
    float limit;                     /* Pa; a sample that reaches it is clipped */
    uint32_t number;                 /* samples taken */
    int due;                         /* samples up to the next decision */
    int held;                        /* samples of the frame so far, TOUCH_FRAME once it is whole */
    int last;                        /* point that was touched last, from 0 */
    float loudest, least;            /* levels: what may be left of a touch, and the least of it so far */
    int behind_gap;                  /* whether the frame may hold the rest of a touch that began in or before a gap */
    int clipped;                     /* samples for which a frame is clipped still */
    int hop, place;                  /* of the newest sample: its hop of those below, and where it lies in that */
    touch_spread whole[TOUCH_MICROPHONES][TOUCH_HOPS]; /* of the samples of each hop, as they came */
    touch_spread tail[TOUCH_MICROPHONES][TOUCH_HOPS];  /* of those that are in the frame still when it is the oldest */
    float state[TOUCH_MICROPHONES][2];                /* of the high-pass */
    float frame[TOUCH_MICROPHONES][TOUCH_FRAME];      /* behind the high-pass; as it came until it is whole */
    float coming[TOUCH_MICROPHONES][TOUCH_HOP];
    float decimated[TOUCH_MICROPHONES][TOUCH_SAMPLES];
    float common;                    /* what a point leaves empty of the frame, and scores are beside */
    float white[TOUCH_NUMBERS];                       /* the frame where its noise is white, of variance 1 */
    float unit;                      /* of the numbers below */
    touch_coordinate turned[TOUCH_NUMBERS];           /* that frame in the directions of a point */
} touch_decoder;

/* Forget everything. limit: Pa, from which on a sample is clipped; 0 where none is. */
void touch_init(touch_decoder *decoder, float limit);

/* Take samples, interleaved by microphone, in Pa, up to the next decision. Returns how many of each microphone were
 * taken, at most count. */
size_t touch_push(touch_decoder *decoder, const float *samples, size_t count);

/* So many samples of each microphone are lost. Decisions go on with the first whole frame behind them. */
void touch_skip(touch_decoder *decoder, uint32_t count);

#ifdef __cplusplus
}
#endif

#endif
