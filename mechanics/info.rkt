#lang info
(define name "mechanics")
