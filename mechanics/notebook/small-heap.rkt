#lang racket/base
;; The memory of a process that lives beside many of its kind, as on the server of a class.
;;
;; Racket on Chez Scheme keeps as much empty memory as there is in use, and looks for garbage
;; whenever 8 MB were taken.  With a quarter, and 4 MB, a kernel is smaller by a tenth;
;; computations take as long.

(require ffi/unsafe/vm)

(provide keep-heap-small!)

;; The garbage of loading is collected at once.
(define (keep-heap-small!)
  (when (eq? (system-type 'vm) 'chez-scheme)
    (vm-eval '(heap-reserve-ratio 0.25))
    (vm-eval `(collect-trip-bytes ,(* 4 1024 1024))))
  (collect-garbage))
