#lang racket/base
;; Numbers of which roundings leave fewer than half of the digits: a note says so.

(require (only-in racket/math exact-ceiling)
         "../../error/note.rkt" "../../error/message-words.rkt"
         "../../generic/describe.rkt")

(provide few-digits? note-unsure with-bound)

;; Of a number of that size, known but for `within`
(define (few-digits? within size) (> within (* 1e-8 size)))

;; things : a list of texts, perhaps empty, of which three are named
(define (note-unsure who things advice)
  (unless (null? things)
    (define more (- (length things) most-named))
    (note-with-result (format "~a: roundings leave fewer than half of the digits of~a~a\n  ~a" who
                       (joined (for/list ([x (in-list things)] [_ (in-range most-named)])
                                 (format "\n  ~a" x))
                               "")
                       (if (> more 0) (format "\n  and ~a more" more) "")
                       advice))))

(define most-named 3)

;; A number, and about how well it is known
(define (with-bound x within)
  (define power (exact-ceiling (/ (log (max within 1e-307)) (log 10))))
  (format "~a, known to about 1e~a" (value->text x) power))
