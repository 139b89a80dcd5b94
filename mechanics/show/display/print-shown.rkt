#lang racket/base
;; Results that are no text: values that a port takes as they are, by `write-special`.

(provide (struct-out special) print-shown)

;; snip : shown by an editor, see formula-snip.rkt
(struct special (snip) #:authentic)

;; shown : a value to be printed, maybe a special; print : -> prints any other, on a line.
;;
;; DrRacket knows how to print a snip; to the ports of a plain editor it must be written.
(define (print-shown shown print)
  (cond [(not (special? shown)) (print shown)]
        [(plain-port? (current-output-port))
         (write-special (special-snip shown))
         (newline)]
        [else (print (special-snip shown))]))

;; Does the port write values as Racket's own ports do?
(define (plain-port? port)
  (eq? (port-write-handler port) (port-write-handler (open-output-bytes))))
