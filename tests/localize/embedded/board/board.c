#include <stdio.h>
#include <stdint.h>
#include "touch_decoder.h"
#define LOAD (*(volatile uint32_t*)0xE000E014)
#define VAL (*(volatile uint32_t*)0xE000E018)
#define CTRL (*(volatile uint32_t*)0xE000E010)
static touch_decoder decoder; static float samples[TOUCH_HOP*TOUCH_MICROPHONES];
int main(void){
  FILE *in=fopen("samples.f32","rb"); if(!in){puts("no file");return 1;}
  LOAD=0xFFFFFF; VAL=0; CTRL=5; touch_init(&decoder,0.0f);
  uint32_t spent=0;
  for(;;){ size_t held=fread(samples,sizeof *samples*TOUCH_MICROPHONES,TOUCH_HOP,in); if(!held) break;
   for(size_t taken=0;taken<held;){
    uint32_t a=VAL; taken+=touch_push(&decoder,samples+taken*TOUCH_MICROPHONES,held-taken); uint32_t b=VAL; spent+=(a-b)&0xFFFFFF;
    if(!decoder.is_new) continue;
    printf("%lu %d %.9g %d %lu",(unsigned long)decoder.decision.sample,(int)decoder.decision.state,(double)decoder.decision.level,decoder.decision.point,(unsigned long)spent); spent=0;
    for(int p=0;decoder.decision.state==TOUCH_TOUCHED&&p<TOUCH_POINTS;p++) printf(" %.9g",(double)decoder.decision.posterior[p]); printf("\n"); } }
  return 0; }
