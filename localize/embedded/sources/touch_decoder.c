/* The decoder of touch_decoder.h. Equations: docs/embed.md of acoustic-fem. */
#include "touch_compiler.h"
#include "touch_decoder.h"

#include <math.h>
#include <string.h>

/* Reflections that are done at once, and how many numbers these have in common. */
#define BLOCK 4
#define COUPLINGS 6
#define STRIDE 4

/* Levels of touches: as in the stream of acoustic-fem. */
#define FADED 0.3f
#define RISEN 2.0f
/* Samples at the beginning of a frame, and level in them, by that of the frame, up to which a touch in it is whole. */
#define BEGINNING 80
#define QUIET 0.1f
/* A fall of 20 dB a second, for one hop. */
#define FADES 0.963829f
/* A point that lies as many nats behind is given up. */
#define SURE 20.0f
/* 1: nothing is given up or left out, to measure the longest that a decision may take. */
#ifndef TOUCH_ALL
#define TOUCH_ALL 0
#endif
/* Bits of 1e6 Pa. A float without its sign is in the order of its bits, and infinity and NaN lie above all numbers. */
#define LARGEST_PRESSURE_BITS 0x49742400u
/* A frame is the last TAIL samples of one hop and the whole of those after it. */
#define TAIL (TOUCH_FRAME % TOUCH_HOP)
/* Of 16-bit tables: bits of the longest frame, whose products with reflections then stay below 31, and those by which
 * products are finer than it; touch_steps are steps times 2 to their power. */
#define LARGEST_BITS 28
#define FINER_BITS 16

static void forget(touch_decoder *decoder, int is_told)
{
    decoder->held = 0;
    decoder->due = is_told ? TOUCH_FRAME % TOUCH_HOP : TOUCH_FRAME;
    decoder->loudest = 0.0f;
    decoder->least = INFINITY;
    decoder->behind_gap = 1;
    decoder->hop = 0;
    decoder->place = TOUCH_HOP - TAIL - 1;
    memset(decoder->whole, 0, sizeof decoder->whole);
    memset(decoder->tail, 0, sizeof decoder->tail);
}

void touch_init(touch_decoder *decoder, float limit)
{
    memset(decoder, 0, sizeof *decoder);
    decoder->limit = limit > 0.0f ? limit : INFINITY;
    forget(decoder, 0);
    decoder->behind_gap = 0;
}

/* Four sums at a time round less than one, and wait less for each other. */
static float product(const float *a, const float *b, int count)
{
    float s0 = 0.0f, s1 = 0.0f, s2 = 0.0f, s3 = 0.0f;
    int k = 0;
    for (; k + 4 <= count; k += 4) {
        s0 += a[k] * b[k];
        s1 += a[k + 1] * b[k + 1];
        s2 += a[k + 2] * b[k + 2];
        s3 += a[k + 3] * b[k + 3];
    }
    for (; k < count; k++) s0 += a[k] * b[k];
    return (s0 + s1) + (s2 + s3);
}

/* A second-order high-pass as a state-variable filter: in single precision its corner may lie far below the sample
 * rate (Zavalishin 2018, "The art of VA filter design", section 4.4). */
static float high_pass(float *state, float sample)
{
    const float above = sample - state[1];
    const float band = touch_high_pass[0] * state[0] + touch_high_pass[1] * above;
    const float low = state[1] + touch_high_pass[1] * state[0] + touch_high_pass[2] * above;
    state[0] = 2.0f * band - state[0];
    state[1] = 2.0f * low - state[1];
    return sample - touch_high_pass[3] * band - low;
}

/* The first frame, filtered as if time had run backwards before it. */
static void begin(touch_decoder *decoder)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        float *frame = decoder->frame[m], *state = decoder->state[m];
        state[0] = 0.0f;
        state[1] = frame[TOUCH_FRAME - 1];
        for (int k = TOUCH_FRAME - 1; k >= 0; k--) (void)high_pass(state, frame[k]);
        for (int k = 0; k < TOUCH_FRAME; k++) frame[k] = high_pass(state, frame[k]);
    }
}

/* The newest outputs of the low-pass, four samples apart. */
static void decimate(touch_decoder *decoder, int count)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        float *out = decoder->decimated[m];
        memmove(out, out + count, (size_t)(TOUCH_SAMPLES - count) * sizeof *out);
        for (int k = TOUCH_SAMPLES - count; k < TOUCH_SAMPLES; k++) {
            const float *first =
                decoder->frame[m] + TOUCH_FRAME - (TOUCH_SAMPLES - 1 - k) * TOUCH_DECIMATION - TOUCH_TAPS;
            out[k] = product(touch_low_pass, first, TOUCH_TAPS);
        }
    }
}

/* Noise made white: a lower triangular matrix, the same for every microphone. */
static void whiten(touch_decoder *decoder, const float *whitening)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        const float *row = whitening;
        for (int k = 0; k < TOUCH_SAMPLES; row += ++k)
            decoder->white[m * TOUCH_SAMPLES + k] = product(row, decoder->decimated[m], k + 1);
    }
}

static float level_of(const float *samples, int count)
{
    float mean = 0.0f, square = 0.0f;
    for (int k = 0; k < count; k++) mean += samples[k];
    mean /= (float)count;
    for (int k = 0; k < count; k++) square += (samples[k] - mean) * (samples[k] - mean);
    return sqrtf(square / (float)count);
}

/* Whether the frame is loud from its beginning on, so that a touch in it may have begun before it. */
static int begins_loud(const touch_decoder *decoder, float level)
{
    const float quiet = fmaxf(touch_silence, QUIET * level);
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        if (level_of(decoder->frame[m], BEGINNING) > quiet) return 1;
    return 0;
}

#if TOUCH_SOUND_NUMBERS > 0
/* u' G u for the gains u of the microphones that leave the least beside sound. */
static float least_beside(float gram[TOUCH_MICROPHONES][TOUCH_MICROPHONES])
{
    float left[TOUCH_MICROPHONES][TOUCH_MICROPHONES], gain[TOUCH_MICROPHONES];
    float mean = 0.0f, largest = 0.0f, sum = 0.0f;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        for (int n = 0; n < TOUCH_MICROPHONES; n++) left[m][n] = gram[m][n] + (m == n ? 1.0f : 0.0f);
        gain[m] = 1.0f;
    }
    /* Gauss: the matrix is symmetric and its eigenvalues are 1 or more, so that no pivot is small. */
    for (int k = 0; k < TOUCH_MICROPHONES; k++)
        for (int m = k + 1; m < TOUCH_MICROPHONES; m++) {
            const float factor = left[m][k] / left[k][k];
            for (int n = k; n < TOUCH_MICROPHONES; n++) left[m][n] -= factor * left[k][n];
            gain[m] -= factor * gain[k];
        }
    for (int k = TOUCH_MICROPHONES - 1; k >= 0; k--) {
        for (int n = k + 1; n < TOUCH_MICROPHONES; n++) gain[k] -= left[k][n] * gain[n];
        gain[k] /= left[k][k];
    }
    for (int m = 0; m < TOUCH_MICROPHONES; m++) mean += gain[m] / (float)TOUCH_MICROPHONES;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        gain[m] = gain[m] / mean - 1.0f;
        largest = fmaxf(largest, fabsf(gain[m]));
    }
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        gain[m] = 1.0f + gain[m] * fminf(1.0f, touch_sound_gain / fmaxf(largest, 1e-12f));
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        for (int n = 0; n < TOUCH_MICROPHONES; n++) sum += gain[m] * gram[m][n] * gain[n];
    return sum;
}

/* Whether sound without a touch explains the frame: what it leaves in the directions that it does not reach. */
static int is_sound(const touch_decoder *decoder)
{
    float gram[TOUCH_MICROPHONES][TOUCH_MICROPHONES] = {{0.0f}};
    float power = 0.0f;
    const float *row = touch_beside;
    for (int k = 0; k < TOUCH_SOUND_NUMBERS; k++) {
        float part[TOUCH_MICROPHONES];
        for (int m = 0; m < TOUCH_MICROPHONES; m++) {
            part[m] = product(row, decoder->white + m * TOUCH_SAMPLES, TOUCH_SAMPLES);
            row += TOUCH_SAMPLES;
        }
        for (int m = 0; m < TOUCH_MICROPHONES; m++)
            for (int n = 0; n < TOUCH_MICROPHONES; n++) gram[m][n] += part[m] * part[n];
    }
    for (int k = 0; k < TOUCH_NUMBERS; k++) power += decoder->white[k] * decoder->white[k];
    return least_beside(gram) <= touch_sound_usual + touch_sound_mismatch * power;
}
#endif

/* Four reflections I - v v', |v|^2 = 2, of the numbers from the first that they change on. First what the frame has of
 * each vector, then what that takes from the frame. Returns where the next reflections are. */
#if TOUCH_INT16
/* Numbers of 16 bits and a frame of 32: sums are exact in 64, and the first number of each vector is held apart. */
static float shortened(int64_t sum)
{
    return (float)(int32_t)(sum >> FINER_BITS);
}

static const touch_number *turn(touch_coordinate *numbers, int point, int stage, const touch_number *held)
{
    const float *couple = touch_couplings[point] + stage / BLOCK * COUPLINGS;
    const float *step = touch_steps[point] + stage, *lead = step + TOUCH_NUMBERS;
    const touch_coordinate *const end = numbers + TOUCH_NUMBERS;
    const touch_number *v = held;
    int64_t s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    numbers += stage;
    for (const touch_coordinate *y = numbers; y < end; y += 2, v += 2 * BLOCK) {
        const int64_t y0 = y[0], y1 = y[1];
        s0 += y0 * v[0], s1 += y0 * v[1], s2 += y0 * v[2], s3 += y0 * v[3];
        s0 += y1 * v[4], s1 += y1 * v[5], s2 += y1 * v[6], s3 += y1 * v[7];
    }
    const float a0 = step[0] * shortened(s0) + lead[0] * (float)numbers[0];
    const float a1 = step[1] * shortened(s1) + lead[1] * (float)numbers[1] - couple[0] * a0;
    const float a2 = step[2] * shortened(s2) + lead[2] * (float)numbers[2] - (couple[1] * a0 + couple[2] * a1);
    const float a3 =
        step[3] * shortened(s3) + lead[3] * (float)numbers[3] - (couple[3] * a0 + couple[4] * a1 + couple[5] * a2);
    numbers[0] -= (int32_t)(lead[0] * a0);
    numbers[1] -= (int32_t)(lead[1] * a1);
    numbers[2] -= (int32_t)(lead[2] * a2);
    numbers[3] -= (int32_t)(lead[3] * a3);
    const int64_t t0 = (int32_t)(step[0] * a0), t1 = (int32_t)(step[1] * a1);
    const int64_t t2 = (int32_t)(step[2] * a2), t3 = (int32_t)(step[3] * a3);
    v = held;
    for (touch_coordinate *y = numbers; y < end; y += 2, v += 2 * BLOCK) {
        y[0] -= (int32_t)((t0 * v[0] + t1 * v[1] + t2 * v[2] + t3 * v[3]) >> FINER_BITS);
        y[1] -= (int32_t)((t0 * v[4] + t1 * v[5] + t2 * v[6] + t3 * v[7]) >> FINER_BITS);
    }
    return v;
}

/* The frame as whole numbers: as large as its energy lets them be, whatever the directions that it is turned into. */
static void begin_turn(touch_decoder *decoder)
{
    for (int k = 0; k < TOUCH_NUMBERS; k++) decoder->turned[k] = (int32_t)(decoder->white[k] / decoder->unit);
}

static void choose_unit(touch_decoder *decoder)
{
    int exponent = 0;
    (void)frexpf(sqrtf(product(decoder->white, decoder->white, TOUCH_NUMBERS)), &exponent);
    decoder->unit = ldexpf(1.0f, exponent - LARGEST_BITS);
}
#else
static const touch_number *turn(touch_coordinate *numbers, int point, int stage, const touch_number *held)
{
    const float *couple = touch_couplings[point] + stage / BLOCK * COUPLINGS;
    const int count = TOUCH_NUMBERS - stage;
    float a0 = 0.0f, a1 = 0.0f, a2 = 0.0f, a3 = 0.0f, b0 = 0.0f, b1 = 0.0f, b2 = 0.0f, b3 = 0.0f;
    const float *v = held;
    numbers += stage;
    for (int k = 0; k < count; k += 4, v += 4 * BLOCK) {
        const float y0 = numbers[k], y1 = numbers[k + 1], y2 = numbers[k + 2], y3 = numbers[k + 3];
        a0 += v[0] * y0, a1 += v[1] * y0, a2 += v[2] * y0, a3 += v[3] * y0;
        b0 += v[4] * y1, b1 += v[5] * y1, b2 += v[6] * y1, b3 += v[7] * y1;
        a0 += v[8] * y2, a1 += v[9] * y2, a2 += v[10] * y2, a3 += v[11] * y2;
        b0 += v[12] * y3, b1 += v[13] * y3, b2 += v[14] * y3, b3 += v[15] * y3;
    }
    a0 += b0, a1 += b1, a2 += b2, a3 += b3;
    a1 -= couple[0] * a0;
    a2 -= couple[1] * a0 + couple[2] * a1;
    a3 -= couple[3] * a0 + couple[4] * a1 + couple[5] * a2;
    v = held;
    for (int k = 0; k < count; k += 4, v += 4 * BLOCK) {
        float y0 = numbers[k], y1 = numbers[k + 1], y2 = numbers[k + 2], y3 = numbers[k + 3];
        y0 -= v[0] * a0, y1 -= v[4] * a0, y2 -= v[8] * a0, y3 -= v[12] * a0;
        y0 -= v[1] * a1, y1 -= v[5] * a1, y2 -= v[9] * a1, y3 -= v[13] * a1;
        y0 -= v[2] * a2, y1 -= v[6] * a2, y2 -= v[10] * a2, y3 -= v[14] * a2;
        y0 -= v[3] * a3, y1 -= v[7] * a3, y2 -= v[11] * a3, y3 -= v[15] * a3;
        numbers[k] = y0, numbers[k + 1] = y1, numbers[k + 2] = y2, numbers[k + 3] = y3;
    }
    return v;
}

static void begin_turn(touch_decoder *decoder)
{
    memcpy(decoder->turned, decoder->white, sizeof decoder->white);
}

static void choose_unit(touch_decoder *decoder)
{
    decoder->unit = 1.0f;
}
#endif

static float squared(const touch_decoder *decoder, int k)
{
    const float number = decoder->unit * (float)decoder->turned[k];
    return number * number;
}

/* A sum and what rounding took from it (Kahan 1965). */
static void add(float *sum, float value)
{
    const float more = value - sum[1], next = sum[0] + more;
    sum[1] = (next - sum[0]) - more;
    sum[0] = next;
}

static float score_at(int point, int power, float missed)
{
    return -touch_half * missed - touch_half_log_determinant[point][power];
}

/* e / (r + l) + f / (r + w) by one division, which takes a chip as long as a dozen products. */
static float pair(const float *energy, const float *value, float r)
{
    const float a = r + value[0], b = r + value[1];
    return (energy[0] * b + energy[1] * a) / (a * b);
}

/* Scores of every fourth of sixteen powers g. With r = 1 / g, 1 / (1 + g l) is r / (r + l). */
static void score_apart(float *score, const float *energy, int point, float missed, int first)
{
    const float *value = touch_eigenvalues[point], *weak = touch_weakness + first;
    const float r0 = weak[0], r1 = weak[STRIDE], r2 = weak[2 * STRIDE], r3 = weak[3 * STRIDE];
    float m0 = 0.0f, m1 = 0.0f, m2 = 0.0f, m3 = 0.0f;
    for (const float *e = energy, *l = value; l < value + TOUCH_RANK; e += 2, l += 2)
        m0 += pair(e, l, r0), m1 += pair(e, l, r1), m2 += pair(e, l, r2), m3 += pair(e, l, r3);
    score[first] = score_at(point, first, missed + r0 * m0);
    score[first + STRIDE] = score_at(point, first + STRIDE, missed + r1 * m1);
    score[first + 2 * STRIDE] = score_at(point, first + 2 * STRIDE, missed + r2 * m2);
    score[first + 3 * STRIDE] = score_at(point, first + 3 * STRIDE, missed + r3 * m3);
}

/* Scores of the three powers from one on that lie between those. */
static void score_between(float *score, const float *energy, int point, float missed, int first)
{
    const float *value = touch_eigenvalues[point], *weak = touch_weakness + first;
    const float r0 = weak[0], r1 = weak[1], r2 = weak[2];
    float m0 = 0.0f, m1 = 0.0f, m2 = 0.0f;
    for (const float *e = energy, *l = value; l < value + TOUCH_RANK; e += 2, l += 2)
        m0 += pair(e, l, r0), m1 += pair(e, l, r1), m2 += pair(e, l, r2);
    score[first] = score_at(point, first, missed + r0 * m0);
    score[first + 1] = score_at(point, first + 1, missed + r1 * m1);
    score[first + 2] = score_at(point, first + 2, missed + r2 * m2);
}

/* The largest log-likelihood over the power of the touch: the parabola around the best of the powers that are tried.
 *
 * The more power, the less is missed and the larger the determinant is: between two powers no score is above that of
 * what the higher one misses with the determinant of the lower one. Every fourth power is scored, and those between
 * where they could be better, or are beside the best. */
static float best_power(const float *energy, int point, float missed)
{
    const float *loss = touch_half_log_determinant[point];
    float score[TOUCH_POWERS];
    int best = 0, is_more = 1;
    uint32_t scored = 0;
    for (int p = 0; p < TOUCH_POWERS; p += 4 * STRIDE) score_apart(score, energy, point, missed, p);
    for (int p = 0; p < TOUCH_POWERS; p += STRIDE)
        if (score[p] > score[best]) best = p;
    while (is_more) {
        is_more = 0;
        for (int group = 0; group < TOUCH_POWERS / STRIDE; group++) {
            const int p = group * STRIDE;
            const float most = p + STRIDE < TOUCH_POWERS ? score[p + STRIDE] + loss[p + STRIDE] : -touch_half * missed;
            const int is_beside = best >= p && best <= p + STRIDE;
            const int is_lower = !is_beside && most - loss[p + 1] <= score[best];
            if (scored >> group & 1u || (is_lower && !TOUCH_ALL)) continue;
            score_between(score, energy, point, missed, p + 1);
            scored |= (uint32_t)1 << group;
            is_more = 1;
            for (int k = p + 1; k < p + STRIDE; k++)
                if (score[k] > score[best]) best = k;
        }
    }
    const int inner = best < 1 ? 1 : best > TOUCH_TRIED - 2 ? TOUCH_TRIED - 2 : best;
    const float left = score[inner - 1], middle = score[inner], right = score[inner + 1];
    const float bend = left - 2.0f * middle + right;
    if (best != inner || bend >= 0.0f) return score[best];
    return middle - (right - left) * (right - left) / (8.0f * bend);
}

/* Log-likelihood of a point: minus what it misses of the frame, beside decoder->common. The frame is turned into the
 * directions of the point, those that it leaves empty first; what lies there alone may already give the point up. A point
 * that has half of decoder->common there, or less, sets it anew: beside what another misses, where a finger was before,
 * the digits that tell it from its neighbours would be lost. */
static float score_of(touch_decoder *decoder, int point, float best)
{
    const touch_number *held = touch_reflections[point];
    float sum[2] = {0.0f, 0.0f}, energy[TOUCH_RANK];
    int stage = 0;
    begin_turn(decoder);
    /* The first point that is scored, whose best is -INFINITY and whose common is INFINITY, is never given up. */
    const float most = best - SURE + touch_half_log_determinant[point][0];
    for (; stage < TOUCH_NUMBERS - TOUCH_RANK; stage += BLOCK) {
        held = turn(decoder->turned, point, stage, held);
        for (int k = 0; k < BLOCK; k++) add(sum, squared(decoder, stage + k));
        if (!TOUCH_ALL && -touch_half * (sum[0] - decoder->common) < most) return -INFINITY;
    }
    if (sum[0] < 0.5f * decoder->common) decoder->common = sum[0];
    const float missed = (sum[0] - decoder->common) - sum[1];
    for (; stage < TOUCH_NUMBERS; stage += BLOCK) held = turn(decoder->turned, point, stage, held);
    for (int k = 0; k < TOUCH_RANK; k++) energy[k] = squared(decoder, TOUCH_NUMBERS - TOUCH_RANK + k);
    return best_power(energy, point, missed);
}

static void locate(touch_decoder *decoder)
{
    touch_decision *decision = &decoder->decision;
    float *posterior = decision->posterior;
    choose_unit(decoder);
    decoder->common = INFINITY;
    /* A finger mostly stays: beside the best point the others are given up early. */
    float best = posterior[decoder->last] = score_of(decoder, decoder->last, -INFINITY), sum = 0.0f;
    for (int point = 0; point < TOUCH_POINTS; point++) {
        if (point == decoder->last) continue;
        const float common = decoder->common;
        const float score = score_of(decoder, point, best);
        if (decoder->common < common) {
            const float less = touch_half * (common - decoder->common);
            best -= less;
            posterior[decoder->last] -= less;
            for (int before = 0; before < point; before++)
                if (before != decoder->last) posterior[before] -= less;
        }
        posterior[point] = score;
        best = fmaxf(best, score);
    }
    for (int point = 0; point < TOUCH_POINTS; point++) {
        posterior[point] = expf(posterior[point] - best);
        sum += posterior[point];
    }
    for (int rank = 0; rank < TOUCH_TOP; rank++) decision->top[rank] = 0;
    for (int point = 0; point < TOUCH_POINTS; point++) {
        posterior[point] /= sum;
        int place = TOUCH_TOP;
        while (place > 0 &&
               (decision->top[place - 1] == 0 || posterior[point] > posterior[decision->top[place - 1] - 1]))
            place--;
        if (place == TOUCH_TOP) continue;
        for (int k = TOUCH_TOP - 1; k > place; k--) decision->top[k] = decision->top[k - 1];
        decision->top[place] = point + 1;
    }
    decision->point = decision->top[0];
    decision->probability = posterior[decision->point - 1];
    decoder->last = decision->point - 1;
}

/* Mean and sum of squares about it, with one more value (Welford 1962). */
static void include(touch_spread *spread, float value, int number)
{
    const float change = value - spread->mean;
    spread->mean += change / (float)number;
    spread->square += change * (value - spread->mean);
}

/* A sample of one microphone as it came: clipped, and how it varies. */
static void watch(touch_decoder *decoder, int m, float sample)
{
    const int place = decoder->place, first = TOUCH_HOP - TAIL;
    if (fabsf(sample) >= decoder->limit) decoder->clipped = TOUCH_FRAME;
    include(&decoder->whole[m][decoder->hop], sample, place + 1);
    if (place >= first) include(&decoder->tail[m][decoder->hop], sample, place - first + 1);
}

/* Where the next sample lies in its hop; a full one gives way to the oldest, which begins anew. */
static void step_on(touch_decoder *decoder)
{
    if (++decoder->place < TOUCH_HOP) return;
    const touch_spread none = {0.0f, 0.0f};
    decoder->place = 0;
    decoder->hop = (decoder->hop + 1) % TOUCH_HOPS;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) decoder->whole[m][decoder->hop] = decoder->tail[m][decoder->hop] = none;
}

/* What is in the frame of the hop that is so many back. */
static const touch_spread *part_of(const touch_decoder *decoder, int m, int back)
{
    const int hop = (decoder->hop + TOUCH_HOPS - back) % TOUCH_HOPS;
    return back == TOUCH_HOPS - 1 ? &decoder->tail[m][hop] : &decoder->whole[m][hop];
}

/* Whether a microphone gives one value only, or less than its noise: by the variance of the frame as it came. */
static int is_dead(const touch_decoder *decoder, int m)
{
    const float newest = part_of(decoder, m, 0)->mean;
    float mean = 0.0f, square = 0.0f;
    for (int back = 0; back < TOUCH_HOPS; back++) {
        const float number = back == TOUCH_HOPS - 1 ? TAIL : TOUCH_HOP;
        mean += number / TOUCH_FRAME * (part_of(decoder, m, back)->mean - newest);
    }
    for (int back = 0; back < TOUCH_HOPS; back++) {
        const float number = back == TOUCH_HOPS - 1 ? TAIL : TOUCH_HOP;
        const float beside = part_of(decoder, m, back)->mean - newest - mean;
        square += part_of(decoder, m, back)->square + number * beside * beside;
    }
    return square < TOUCH_FRAME * touch_dead * touch_dead;
}

static touch_state judge(touch_decoder *decoder)
{
    float level = 0.0f;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) level = fmaxf(level, level_of(decoder->frame[m], TOUCH_FRAME));
    decoder->decision.level = level;
    if (decoder->clipped > 0) return TOUCH_UNREADABLE;
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        if (is_dead(decoder, m)) return TOUCH_UNREADABLE;
    decoder->loudest *= FADES;
    if (decoder->behind_gap) decoder->behind_gap = level > touch_silence && begins_loud(decoder, level);
    if (level <= touch_silence) return TOUCH_NONE;
    if (decoder->behind_gap) return TOUCH_UNREADABLE;
    if (level < fminf(FADED * decoder->loudest, RISEN * decoder->least)) {
        decoder->least = fminf(decoder->least, level);
        return TOUCH_FADING;
    }
#if TOUCH_SOUND_NUMBERS > 0
    whiten(decoder, touch_sound_whitening);
    if (is_sound(decoder)) return TOUCH_SOUND;
#endif
    whiten(decoder, touch_whitening);
    if (level < FADED * decoder->loudest) decoder->loudest = 0.0f; /* a new one */
    if (level > decoder->loudest) decoder->loudest = decoder->least = level;
    decoder->least = fminf(decoder->least, level);
    locate(decoder);
    return TOUCH_TOUCHED;
}

static void decide(touch_decoder *decoder)
{
    touch_decision *decision = &decoder->decision;
    decoder->due = TOUCH_HOP;
    decoder->is_new = 1;
    decision->sample = decoder->number;
    decision->point = 0;
    decision->probability = decision->level = decision->mean = 0.0f;
    decision->state = decoder->held < TOUCH_FRAME ? TOUCH_UNREADABLE : judge(decoder);
    if (decision->state == TOUCH_UNREADABLE) return;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) decision->mean += part_of(decoder, m, 0)->mean;
    decision->mean /= (float)TOUCH_MICROPHONES;
}

/* Whether a sample is a pressure: neither NaN nor too large. By its bits, because options of compilers may assume that
 * there is no NaN. */
static int is_pressure(float sample)
{
    uint32_t bits;
    memcpy(&bits, &sample, sizeof bits);
    return (bits & 0x7FFFFFFFu) < LARGEST_PRESSURE_BITS;
}

static int take(touch_decoder *decoder, const float *samples)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        if (!is_pressure(samples[m])) return 0;
    step_on(decoder);
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        watch(decoder, m, samples[m]);
        if (decoder->held < TOUCH_FRAME)
            decoder->frame[m][decoder->held] = samples[m];
        else
            decoder->coming[m][TOUCH_HOP - decoder->due] = high_pass(decoder->state[m], samples[m]);
    }
    return 1;
}

size_t touch_push(touch_decoder *decoder, const float *samples, size_t count)
{
    decoder->is_new = 0;
    for (size_t taken = 0; taken < count; taken++, samples += TOUCH_MICROPHONES) {
        const int is_whole = decoder->held == TOUCH_FRAME;
        decoder->number++;
        if (decoder->clipped > 0) decoder->clipped--;
        if (!take(decoder, samples)) {
            forget(decoder, 1);
            continue;
        }
        decoder->due--;
        if (!is_whole && ++decoder->held == TOUCH_FRAME) {
            begin(decoder);
            decimate(decoder, TOUCH_SAMPLES);
        }
        if (decoder->due > 0) continue;
        if (is_whole) {
            for (int m = 0; m < TOUCH_MICROPHONES; m++) {
                float *frame = decoder->frame[m];
                memmove(frame, frame + TOUCH_HOP, (TOUCH_FRAME - TOUCH_HOP) * sizeof *frame);
                memcpy(frame + TOUCH_FRAME - TOUCH_HOP, decoder->coming[m], sizeof decoder->coming[m]);
            }
            decimate(decoder, TOUCH_HOP / TOUCH_DECIMATION);
        }
        decide(decoder);
        return taken + 1;
    }
    return count;
}

void touch_skip(touch_decoder *decoder, uint32_t count)
{
    decoder->is_new = 0;
    decoder->number += count;
    forget(decoder, 0);
}
