/* In place of the library PDM of Arduino. */
#ifndef STUB_PDM_H
#define STUB_PDM_H

struct PDMClass {
    int begin(int channels, int rate);
    void onReceive(void (*call)(void));
    void setBufferSize(int bytes);
    int available();
    int read(void *buffer, int bytes);
};
extern PDMClass PDM;
#endif
