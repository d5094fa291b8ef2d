/* Sketch of touch_board_arduino.cpp, which has setup and loop. Its folder must have its name, touch_arduino. */
