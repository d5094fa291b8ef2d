/* The tracker on the host: decisions from stdin, each as sample, state, level, mean pressure, point and the probability
 * of every point; a line for every event. */
#include <stdio.h>

#include "touch_tracker.h"

typedef struct {
    uint32_t sample;
    int32_t state;
    float level, mean;
    int32_t point;
    float posterior[TOUCH_POINTS];
} record;

int main(void)
{
    static touch_tracker tracker;
    record given;
    touch_tracker_init(&tracker, TOUCH_DELAY);
    while (fread(&given, sizeof given, 1, stdin) == 1) {
        touch_decision decision = {0};
        touch_event events[TOUCH_EVENTS_AT_ONCE];
        decision.sample = given.sample;
        decision.state = (touch_state)given.state;
        decision.level = given.level;
        decision.mean = given.mean;
        decision.point = given.point;
        for (int point = 0; point < TOUCH_POINTS; point++) decision.posterior[point] = given.posterior[point];
        const int count = touch_tracker_take(&tracker, &decision, events);
        for (int k = 0; k < count; k++)
            printf("%lu %d %lu %d %.9g %.9g %.9g\n", (unsigned long)events[k].sample, (int)events[k].kind,
                   (unsigned long)events[k].touch, events[k].point, (double)events[k].probability,
                   (double)events[k].level, (double)events[k].latency);
    }
    return 0;
}
