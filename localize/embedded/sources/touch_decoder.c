/* The decoder of touch_decoder.h. Equations: docs/embedded.md of acoustic-fem. */
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
/* A fall of 20 dB a second, for one hop. */
#define FADES 0.963829f
/* A point that lies as many nats behind is given up. */
#ifndef SURE
#define SURE 20.0f
#endif
#define LARGEST_PRESSURE 1e6f
#define LARGEST_SCORE 1e30f

static void forget(touch_decoder *decoder, int is_told)
{
    decoder->held = 0;
    decoder->due = is_told ? TOUCH_FRAME % TOUCH_HOP : TOUCH_FRAME;
    decoder->loudest = 0.0f;
    decoder->least = INFINITY;
    decoder->dead = 0;
    memset(decoder->repeated, 0, sizeof decoder->repeated);
}

void touch_init(touch_decoder *decoder, float limit)
{
    memset(decoder, 0, sizeof *decoder);
    decoder->limit = limit > 0.0f ? limit : INFINITY;
    forget(decoder, 0);
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
static void whiten(touch_decoder *decoder)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++) {
        const float *row = touch_whitening;
        for (int k = 0; k < TOUCH_SAMPLES; row += ++k)
            decoder->white[m * TOUCH_SAMPLES + k] = product(row, decoder->decimated[m], k + 1);
    }
}

static float level_of(const float *frame)
{
    float mean = 0.0f, square = 0.0f;
    for (int k = 0; k < TOUCH_FRAME; k++) mean += frame[k];
    mean /= (float)TOUCH_FRAME;
    for (int k = 0; k < TOUCH_FRAME; k++) square += (frame[k] - mean) * (frame[k] - mean);
    return sqrtf(square / (float)TOUCH_FRAME);
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

/* Four reflections I - v v', |v|^2 = 2, of the numbers from the first that they change on. Returns where the next are. */
static const touch_number *turn(float *numbers, int point, int stage, const touch_number *held)
{
    const float *couple = touch_couplings[point] + stage / BLOCK * COUPLINGS;
    const int count = TOUCH_NUMBERS - stage;
    float a0 = 0.0f, a1 = 0.0f, a2 = 0.0f, a3 = 0.0f, b0 = 0.0f, b1 = 0.0f, b2 = 0.0f, b3 = 0.0f;
    const touch_number *vector = held;
    numbers += stage;
    for (int k = 0; k < count; k += 4, vector += 4 * BLOCK) {
        const float y0 = numbers[k], y1 = numbers[k + 1], y2 = numbers[k + 2], y3 = numbers[k + 3];
        a0 += (float)vector[0] * y0, a1 += (float)vector[1] * y0, a2 += (float)vector[2] * y0, a3 += (float)vector[3] * y0;
        b0 += (float)vector[4] * y1, b1 += (float)vector[5] * y1, b2 += (float)vector[6] * y1, b3 += (float)vector[7] * y1;
        a0 += (float)vector[8] * y2, a1 += (float)vector[9] * y2, a2 += (float)vector[10] * y2, a3 += (float)vector[11] * y2;
        b0 += (float)vector[12] * y3, b1 += (float)vector[13] * y3, b2 += (float)vector[14] * y3, b3 += (float)vector[15] * y3;
    }
    a0 += b0, a1 += b1, a2 += b2, a3 += b3;
#if TOUCH_INT16
    const float *step = touch_steps[point] + stage, *lead = step + sizeof touch_steps[point] / sizeof *step / 2;
    const int more = count > 2;
    a0 = step[0] * a0 + lead[0] * numbers[0];
    a1 = step[1] * a1 + lead[1] * numbers[1];
    a2 = more ? step[2] * a2 + lead[2] * numbers[2] : 0.0f;
    a3 = more ? step[3] * a3 + lead[3] * numbers[3] : 0.0f;
#endif
    a1 -= couple[0] * a0;
    a2 -= couple[1] * a0 + couple[2] * a1;
    a3 -= couple[3] * a0 + couple[4] * a1 + couple[5] * a2;
#if TOUCH_INT16
    numbers[0] -= lead[0] * a0;
    numbers[1] -= lead[1] * a1;
    if (more) {
        numbers[2] -= lead[2] * a2;
        numbers[3] -= lead[3] * a3;
    }
    a0 *= step[0], a1 *= step[1], a2 *= step[2], a3 *= step[3];
#endif
    vector = held;
    for (int k = 0; k < count; k += 4, vector += 4 * BLOCK) {
        float y0 = numbers[k], y1 = numbers[k + 1], y2 = numbers[k + 2], y3 = numbers[k + 3];
        y0 -= (float)vector[0] * a0, y1 -= (float)vector[4] * a0, y2 -= (float)vector[8] * a0, y3 -= (float)vector[12] * a0;
        y0 -= (float)vector[1] * a1, y1 -= (float)vector[5] * a1, y2 -= (float)vector[9] * a1, y3 -= (float)vector[13] * a1;
        y0 -= (float)vector[2] * a2, y1 -= (float)vector[6] * a2, y2 -= (float)vector[10] * a2, y3 -= (float)vector[14] * a2;
        y0 -= (float)vector[3] * a3, y1 -= (float)vector[7] * a3, y2 -= (float)vector[11] * a3, y3 -= (float)vector[15] * a3;
        numbers[k] = y0, numbers[k + 1] = y1, numbers[k + 2] = y2, numbers[k + 3] = y3;
    }
    return vector;
}

/* A sum and what rounding took from it (Kahan 1965). */
static void add(float *sum, float value)
{
    const float more = value - sum[1], next = sum[0] + more;
    sum[1] = (next - sum[0]) - more;
    sum[0] = next;
}

/* Scores of four powers, from one on and some apart. */
static void score_powers(float *score, const float *energy, int point, float missed, int first, int apart)
{
    const float *power = touch_powers + first, *value = touch_eigenvalues[point];
    float m0 = missed, m1 = missed, m2 = missed, m3 = missed;
    for (int k = 0; k < TOUCH_RANK; k++) {
        m0 += energy[k] / (1.0f + power[0] * value[k]);
        m1 += energy[k] / (1.0f + power[apart] * value[k]);
        m2 += energy[k] / (1.0f + power[2 * apart] * value[k]);
        m3 += energy[k] / (1.0f + power[3 * apart] * value[k]);
    }
    const float *loss = touch_half_log_determinant[point] + first;
    score[first] = -touch_half * m0 - loss[0];
    score[first + apart] = -touch_half * m1 - loss[apart];
    score[first + 2 * apart] = -touch_half * m2 - loss[2 * apart];
    score[first + 3 * apart] = -touch_half * m3 - loss[3 * apart];
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
    for (int p = 0; p < TOUCH_POWERS; p += 4 * STRIDE) score_powers(score, energy, point, missed, p, STRIDE);
    for (int p = 0; p < TOUCH_POWERS; p += STRIDE)
        if (score[p] > score[best]) best = p;
    while (is_more) {
        is_more = 0;
        for (int group = 0; group < TOUCH_POWERS / STRIDE; group++) {
            const int p = group * STRIDE;
            const float most = p + STRIDE < TOUCH_POWERS ? score[p + STRIDE] + loss[p + STRIDE] : -touch_half * missed;
            const int is_beside = best >= p && best <= p + STRIDE;
            if (scored >> group & 1u || (!is_beside && most - loss[p + 1] <= score[best])) continue;
            score_powers(score, energy, point, missed, p, 1);
            scored |= (uint32_t)1 << group;
            is_more = 1;
            for (int k = p; k < p + STRIDE; k++)
                if (score[k] > score[best]) best = k;
        }
    }
    const int inner = best < 1 ? 1 : best > TOUCH_TRIED - 2 ? TOUCH_TRIED - 2 : best;
    const float left = score[inner - 1], middle = score[inner], right = score[inner + 1];
    const float bend = left - 2.0f * middle + right;
    if (best != inner || bend >= 0.0f) return score[best];
    return middle - (right - left) * (right - left) / (8.0f * bend);
}

/* Log-likelihood of a point: minus what it misses of the frame, beside what the first point leaves empty. The frame is turned into the directions of the point,
 * those that it leaves empty first; what lies there alone may already give the point up. */
static float score_of(touch_decoder *decoder, int point, float best)
{
    const touch_number *held = touch_reflections[point];
    float *turned = decoder->turned, sum[2] = {0.0f, 0.0f};
    int stage = 0;
    memcpy(turned, decoder->white, sizeof decoder->white);
    /* The first point that is scored, whose best is -INFINITY, is never given up. */
    const float most = best - SURE + touch_half_log_determinant[point][0];
    for (; stage < TOUCH_NUMBERS - TOUCH_RANK; stage += BLOCK) {
        held = turn(turned, point, stage, held);
        for (int k = 0; k < BLOCK; k++) add(sum, turned[stage + k] * turned[stage + k]);
        if (-touch_half * (sum[0] - decoder->common) < most) return -INFINITY;
    }
    if (best < -LARGEST_SCORE) decoder->common = sum[0];
    const float missed = (sum[0] - decoder->common) - sum[1];
    for (; stage < TOUCH_NUMBERS; stage += BLOCK) held = turn(turned, point, stage, held);
    float *energy = turned + TOUCH_NUMBERS - TOUCH_RANK;
    for (int k = 0; k < TOUCH_RANK; k++) energy[k] *= energy[k];
    return best_power(energy, point, missed);
}

static void locate(touch_decoder *decoder)
{
    touch_decision *decision = &decoder->decision;
    float *posterior = decision->posterior;
    /* A finger mostly stays: beside the best point the others are given up early. */
    float best = posterior[decoder->last] = score_of(decoder, decoder->last, -INFINITY), sum = 0.0f;
    for (int point = 0; point < TOUCH_POINTS; point++) {
        if (point == decoder->last) continue;
        posterior[point] = score_of(decoder, point, best);
        best = fmaxf(best, posterior[point]);
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

static touch_state judge(touch_decoder *decoder)
{
    float level = 0.0f;
    for (int m = 0; m < TOUCH_MICROPHONES; m++) level = fmaxf(level, level_of(decoder->frame[m]));
    decoder->decision.level = level;
    if (decoder->number < decoder->clipped || decoder->dead) return TOUCH_UNREADABLE;
    decoder->loudest *= FADES;
    if (level <= touch_silence) return TOUCH_NONE;
    if (level < fminf(FADED * decoder->loudest, RISEN * decoder->least)) {
        decoder->least = fminf(decoder->least, level);
        return TOUCH_FADING;
    }
    whiten(decoder);
#if TOUCH_SOUND_NUMBERS > 0
    if (is_sound(decoder)) return TOUCH_SOUND;
#endif
    if (level < FADED * decoder->loudest) decoder->loudest = 0.0f; /* a new one */
    if (level > decoder->loudest) decoder->loudest = decoder->least = level;
    decoder->least = fminf(decoder->least, level);
    locate(decoder);
    return TOUCH_TOUCHED;
}

static void decide(touch_decoder *decoder)
{
    decoder->due = TOUCH_HOP;
    decoder->is_new = 1;
    decoder->decision.sample = decoder->number;
    decoder->decision.point = 0;
    decoder->decision.probability = 0.0f;
    decoder->decision.level = 0.0f;
    decoder->decision.state = decoder->held < TOUCH_FRAME ? TOUCH_UNREADABLE : judge(decoder);
}

/* A sample of one microphone as it came: clipped, or the same as 249 before it? */
static void watch(touch_decoder *decoder, int m, float sample)
{
    if (fabsf(sample) >= decoder->limit) decoder->clipped = decoder->number + TOUCH_FRAME;
    const uint32_t bit = (uint32_t)1 << m;
    const int is_same = sample <= decoder->previous[m] && sample >= decoder->previous[m];
    if (!is_same) decoder->repeated[m] = 0;
    if (decoder->repeated[m] < TOUCH_FRAME) decoder->repeated[m]++;
    decoder->dead = decoder->repeated[m] == TOUCH_FRAME ? decoder->dead | bit : decoder->dead & ~bit;
    decoder->previous[m] = sample;
}

static int take(touch_decoder *decoder, const float *samples)
{
    for (int m = 0; m < TOUCH_MICROPHONES; m++)
        if (!(fabsf(samples[m]) < LARGEST_PRESSURE)) return 0;
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
